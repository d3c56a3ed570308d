// SPDX-License-Identifier: MIT
// A point of 8 x 8 pixels for a tile of the image, of which the vertices count them row by row from the lower left; none
// where nothing is to be drawn. What is left out costs no fragment, which a test in the fragments themselves would.

layout(std140) uniform squares_block {
  ivec2 size_px;  // of the image
  int reach_px;
  int columns;
} squares;

ivec2 tile_of_vertex() { return ivec2(gl_VertexID % squares.columns, gl_VertexID / squares.columns); }

void place_point(ivec2 tile, bool is_drawn) {
  // A point whose middle is outside the image would be left out as a whole.
  vec2 middle = min(vec2(8 * tile) + 4.0, vec2(squares.size_px) - 0.5);
  gl_Position = is_drawn ? vec4(2.0 * middle / vec2(squares.size_px) - 1.0, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
  gl_PointSize = 8.0;
}
