#version 450 core
// SPDX-License-Identifier: MIT
// Whether 8 x 8 pixels have a detected one among them: one that goes on with a line or has a class.
#include "generated/edges.glsl"

uniform sampler2D detection_map;  // strength, class
layout(location = 0) out float has_edge;

void main() {
  ivec2 low = ivec2(gl_FragCoord.xy) * 8;
  ivec2 high = min(low + 8, textureSize(detection_map, 0));
  vec2 largest = vec2(0.0);
  for (int y = low.y; y < high.y; ++y)
    for (int x = low.x; x < high.x; ++x) largest = max(largest, abs(texelFetch(detection_map, ivec2(x, y), 0).rg));
  has_edge = largest.r >= edges.weak || largest.g > 0.0 ? 1.0 : 0.0;
}
