#version 450 core
// SPDX-License-Identifier: MIT
// Whether 8 x 8 pixels have a placed line among them.
#include "lib/placed.glsl"

uniform sampler2D placed_map;
layout(location = 0) out float has_line;

void main() {
  ivec2 low = ivec2(gl_FragCoord.xy) * 8;
  ivec2 high = min(low + 8, textureSize(placed_map, 0));
  bool found = false;
  for (int y = low.y; y < high.y && !found; ++y)
    for (int x = low.x; x < high.x; ++x) found = found || is_placed(texelFetch(placed_map, ivec2(x, y), 0));
  has_line = found ? 1.0 : 0.0;
}
