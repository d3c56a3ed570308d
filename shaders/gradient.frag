#version 450 core
// SPDX-License-Identifier: MIT
// The improved Sobel filter of 3.4.3, on the depth map and on the normal map at once:
// g = 1/8 (|A-X| + 2|B-X| + |C-X| + 2|D-X| + 2|E-X| + |F-X| + 2|G-X| + |H-X|). Neighbours outside are clamped.

uniform sampler2D normal_and_depth_map;
layout(location = 0) out vec2 gradient;  // g of depth, mean of g over the normal's x, y, z

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  ivec2 low = max(at - 1, ivec2(0));
  ivec2 high = min(at + 1, textureSize(normal_and_depth_map, 0) - 1);
  vec4 here = texelFetch(normal_and_depth_map, at, 0);
#define DIFFERENCE(place) abs(texelFetch(normal_and_depth_map, place, 0) - here)
  vec4 corners = DIFFERENCE(low) + DIFFERENCE(ivec2(high.x, low.y)) + DIFFERENCE(ivec2(low.x, high.y)) + DIFFERENCE(high);
  vec4 sides = DIFFERENCE(ivec2(at.x, low.y)) + DIFFERENCE(ivec2(low.x, at.y)) + DIFFERENCE(ivec2(high.x, at.y)) +
               DIFFERENCE(ivec2(at.x, high.y));
  vec4 g = (corners + 2.0 * sides) / 8.0;
  gradient = vec2(g.w, (g.x + g.y + g.z) / 3.0);
}
