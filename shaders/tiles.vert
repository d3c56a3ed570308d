#version 450 core
// SPDX-License-Identifier: MIT
// The tiles that a map says are to be drawn.

uniform sampler2D tile_map;
#include "lib/tile_point.glsl"

void main() {
  ivec2 tile = tile_of_vertex();
  place_point(tile, texelFetch(tile_map, tile, 0).r > 0.0);
}
