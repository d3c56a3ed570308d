#version 450 core
// SPDX-License-Identifier: MIT
// The tiles that a map says have something, and those from which one of them is at most `reach_px` away along a row or column.

uniform sampler2D tile_map;
#include "lib/tile_point.glsl"

void main() {
  ivec2 tile = tile_of_vertex(), last = textureSize(tile_map, 0) - 1;
  int beyond = (squares.reach_px + 7) / 8;
  float found = 0.0;
  for (int y = max(tile.y - beyond, 0); y <= min(tile.y + beyond, last.y); ++y)
    for (int x = max(tile.x - beyond, 0); x <= min(tile.x + beyond, last.x); ++x) found += texelFetch(tile_map, ivec2(x, y), 0).r;
  place_point(tile, found > 0.0);
}
