// SPDX-License-Identifier: MIT
// Differential operators of 3 x 3 pixels (Saito and Takahashi 1990), named as the paper's Table 1 names neighbours.

// Where the operator is taken: a pixel of the image's border has the value of the nearest one whose neighbours all lie
// inside, so that the border of the image is no edge.
ivec2 operator_centre(ivec2 at, ivec2 size) {
  ivec2 low = min(ivec2(1), (size - 1) / 2);
  return clamp(at, low, max(size - 2, low));
}

// Of the map around `at`: 0 on even ground, |dx| + |dy| on a slope, half its height beside a step.
vec4 first_order(sampler2D map, ivec2 at) {
  ivec2 size = textureSize(map, 0);
  ivec2 centre = operator_centre(at, size);
  ivec2 low = max(centre - 1, ivec2(0)), high = min(centre + 1, size - 1);
  vec4 a = texelFetch(map, low, 0), c = texelFetch(map, ivec2(high.x, low.y), 0);
  vec4 f = texelFetch(map, ivec2(low.x, high.y), 0), h = texelFetch(map, high, 0);
  vec4 b = texelFetch(map, ivec2(centre.x, low.y), 0), g = texelFetch(map, ivec2(centre.x, high.y), 0);
  vec4 d = texelFetch(map, ivec2(low.x, centre.y), 0), e = texelFetch(map, ivec2(high.x, centre.y), 0);
  return (abs(a + 2.0 * b + c - f - 2.0 * g - h) + abs(c + 2.0 * e + h - a - 2.0 * d - f)) / 8.0;
}
