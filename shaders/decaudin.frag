#version 450 core
// SPDX-License-Identifier: MIT
// Decaudin's p = min(((gmax - gmin) / k)^2, 1) of each gradient, the largest of them being the ink. The strength is 1 where
// that is a half.
#include "generated/edges.glsl"
#include "generated/decaudin.glsl"

uniform sampler2D gradient_map;  // of the normal's x, y and z, of the depth
layout(location = 0) out vec2 edge;  // strength, class

#include "lib/edge_class.glsl"

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  ivec2 low = max(at - 1, ivec2(0));
  ivec2 high = min(at + 1, textureSize(gradient_map, 0) - 1);
  vec4 smallest = texelFetch(gradient_map, at, 0);
  vec4 largest = smallest;
#define INCLUDE(place) { vec4 g = texelFetch(gradient_map, place, 0); smallest = min(smallest, g); largest = max(largest, g); }
  INCLUDE(low)
  INCLUDE(ivec2(at.x, low.y))
  INCLUDE(ivec2(high.x, low.y))
  INCLUDE(ivec2(low.x, at.y))
  INCLUDE(ivec2(high.x, at.y))
  INCLUDE(ivec2(low.x, high.y))
  INCLUDE(ivec2(at.x, high.y))
  INCLUDE(high)
  vec4 ratio = (largest - smallest) / vec4(vec3(decaudin.k_normal), decaudin.k_depth);
  float most = max(max(ratio.x, ratio.y), max(ratio.z, ratio.w));
  float strength = 2.0 * most * most;
  edge = vec2(strength, strength >= edges.weak ? class_of_surfaces(2) : class_none);
}
