#version 450 core
// SPDX-License-Identifier: MIT
// A square of 16 x 16 pixels for each instance, row by row from the lower left; none where no line is in reach. What is
// left out costs no fragment, which a test in the fragments themselves would.

uniform sampler2D tile_map;
layout(std140) uniform squares_block {
  ivec2 size_px;  // of the image
  int reach_px;
  int columns;
} squares;

#include "lib/tiles.glsl"

void main() {
  ivec2 low = 16 * ivec2(gl_InstanceID % squares.columns, gl_InstanceID / squares.columns);
  ivec2 high = min(low + 16, squares.size_px);
  ivec2 corner = ivec2((gl_VertexID & 1) != 0 ? high.x : low.x, (gl_VertexID & 2) != 0 ? high.y : low.y);
  bool is_drawn = has_line_in(low - squares.reach_px, high - 1 + squares.reach_px);
  gl_Position = is_drawn ? vec4(2.0 * vec2(corner) / vec2(squares.size_px) - 1.0, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
