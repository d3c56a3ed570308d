#version 450 core
// SPDX-License-Identifier: MIT
// gmax - gmin in the 3 x 3 region around each pixel (3.4.4), for both gradients. Kept as a pass of its own, so that
// a change of k does not compute it again.

uniform sampler2D gradient_map;
layout(location = 0) out vec2 range;  // of the depth gradient, of the normal gradient

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  ivec2 low = max(at - 1, ivec2(0));
  ivec2 high = min(at + 1, textureSize(gradient_map, 0) - 1);
  vec2 smallest = texelFetch(gradient_map, at, 0).rg;
  vec2 largest = smallest;
#define INCLUDE(place) { vec2 g = texelFetch(gradient_map, place, 0).rg; smallest = min(smallest, g); largest = max(largest, g); }
  INCLUDE(low)
  INCLUDE(ivec2(at.x, low.y))
  INCLUDE(ivec2(high.x, low.y))
  INCLUDE(ivec2(low.x, at.y))
  INCLUDE(ivec2(high.x, at.y))
  INCLUDE(ivec2(low.x, high.y))
  INCLUDE(ivec2(at.x, high.y))
  INCLUDE(high)
  range = largest - smallest;
}
