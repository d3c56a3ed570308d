#version 450 core
// SPDX-License-Identifier: MIT
// A point of 8 x 8 pixels for each tile, row by row from the lower left; none where no line is in reach. What is left out costs
// no fragment, which a test in the fragments themselves would.

uniform sampler2D tile_map;
layout(std140) uniform squares_block {
  ivec2 size_px;  // of the image
  int reach_px;
  int columns;
} squares;

#include "lib/tiles.glsl"

void main() {
  ivec2 low = 8 * ivec2(gl_VertexID % squares.columns, gl_VertexID / squares.columns);
  bool is_drawn = has_line_in(low - squares.reach_px, low + 7 + squares.reach_px);
  // A point whose middle is outside the image would be left out as a whole.
  vec2 middle = min(vec2(low) + 4.0, vec2(squares.size_px) - 0.5);
  gl_Position = is_drawn ? vec4(2.0 * middle / vec2(squares.size_px) - 1.0, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
  gl_PointSize = 8.0;
}
