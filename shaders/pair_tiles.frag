#version 450 core
// SPDX-License-Identifier: MIT
// The largest angle and gap of the pairs that pixels of a tile of 8 x 8 belong to: whatever the limits are, lines are only
// where these reach them.

uniform sampler2D pair_map;  // lib/pair_map.glsl
layout(location = 0) out vec2 largest;  // degrees, pixel sizes

#include "lib/pair_map.glsl"

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * 8;
  ivec2 high = min(first + 8, textureSize(pair_map, 0));
  ivec2 low = max(first - 1, 0);  // pairs are their left or lower pixel's
  largest = vec2(0.0);
  for (int y = low.y; y < high.y; ++y) {
    for (int x = low.x; x < high.x; ++x) {
      vec4 pair = abs(texelFetch(pair_map, ivec2(x, y), 0));
      vec2 gaps = pair.zw * vec2(greaterThan(pair.zw, vec2(meeting_gap)));
      largest = max(largest, max(vec2(pair.x, gaps.x), vec2(pair.y, gaps.y)));
    }
  }
}
