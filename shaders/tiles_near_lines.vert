#version 450 core
// SPDX-License-Identifier: MIT
// The tiles with a line at most `reach_px`, up to 4, from one of their pixels, along a row or column.

uniform usampler2D bit_map;
#include "lib/line_bits.glsl"
#include "lib/tile_point.glsl"

void main() {
  ivec2 tile = tile_of_vertex();
  int reach = squares.reach_px;
  uvec2 near = uvec2(0u);
  for (int i = 0; i < 4; ++i) near |= bits_from(8 * tile + reach * (2 * ivec2(i & 1, i >> 1) - 1));
  place_point(tile, near != uvec2(0u));
}
