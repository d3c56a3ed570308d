#version 450 core
// SPDX-License-Identifier: MIT
// Which of 8 x 8 pixels have a line that is drawn, a bit each (lib/line_bits.glsl).
#include "lib/class_width.glsl"
#include "lib/placed.glsl"

uniform sampler2D placed_map;
uniform sampler2D tile_map;
layout(location = 0) out uvec2 bits;

bool is_drawn(ivec2 at) {
  vec4 texel = texelFetch(placed_map, at, 0);
  return is_placed(texel) && class_width(unpacked_line(texel).line_class) * texel.a > 0.0;
}

void main() {
  ivec2 tile = ivec2(gl_FragCoord.xy), low = 8 * tile;
  ivec2 last = textureSize(placed_map, 0) - 1;
  int rows = texelFetch(tile_map, tile, 0).r > 0.0 ? min(last.y - low.y, 7) + 1 : 0;
  bits = uvec2(0u);
  for (int y = 0; y < rows; ++y) {
    uint row = 0u;
    for (int x = 0; x < 8; ++x) {
      ivec2 at = low + ivec2(x, y);
      row |= at.x <= last.x && is_drawn(min(at, last)) ? 1u << x : 0u;
    }
    bits |= y < 4 ? uvec2(row << 8 * y, 0u) : uvec2(0u, row << 8 * (y - 4));
  }
}
