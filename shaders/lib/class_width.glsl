// SPDX-License-Identifier: MIT
// What the widths of lines are times, by class.

layout(std140) uniform widths_block {
  vec4 of_class[2];  // times the width: object, silhouette, crease, normal | shadow, material
  float height_px;
  int need_distance;  // else neither distances nor the visible range are looked at
} widths;

// By comparisons: an index into the block that differs from pixel to pixel is dear on the software renderer.
float class_width(float line_class) {
  vec4 first = widths.of_class[0] * vec4(equal(vec4(line_class), vec4(1.0, 2.0, 3.0, 4.0)));
  vec2 last = widths.of_class[1].xy * vec2(equal(vec2(line_class), vec2(5.0, 6.0)));
  return dot(first, vec4(1.0)) + last.x + last.y;
}
