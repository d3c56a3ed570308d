// SPDX-License-Identifier: MIT
// Where strokes lie in what is drawn, and what their points say.

layout(std140) uniform strokes_block {
  vec2 whole_size_px;  // of the image that the strokes are of
  vec2 corner_px;      // of the part that is drawn, from the whole's lower left corner
  vec2 size_px;        // of the part
  float hidden_share;
  float length_px;     // of one repetition of the paint
  float grain;
  int is_stretched;
  vec2 padding;
} strokes;

const int segment_flag = 1, hidden_flag = 2, closed_flag = 4;

int flags_of(vec4 paint) { return int(paint.y) / 16; }
int class_of(vec4 paint) { return int(paint.y) % 16; }
bool is_segment(vec4 paint) { return (flags_of(paint) & segment_flag) != 0; }

vec2 to_clip(vec2 at) { return 2.0 * (vec2(at.x, strokes.whole_size_px.y - at.y) - strokes.corner_px) / strokes.size_px - 1.0; }
vec2 from_fragment(vec2 fragment) {
  vec2 at = fragment + strokes.corner_px;
  return vec2(at.x, strokes.whole_size_px.y - at.y);
}
