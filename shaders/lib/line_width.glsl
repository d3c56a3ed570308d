// SPDX-License-Identifier: MIT
// How wide a placed line is, by all but its distance. Needs lib/placed.glsl.
#include "generated/line.glsl"

layout(std140) uniform widths_block {
  vec4 of_class[2];  // times the width: object, silhouette, crease, normal | shadow, material
  float height_px;
  int need_distance;  // else neither distances nor the visible range are looked at
} widths;

float class_width(float line_class) {
  int i = int(line_class + 0.5) - 1;
  return widths.of_class[i / 4][i % 4];
}

// In pixels, for widths in pixels or percent.
float even_width(Placed placed) {
  float unit = line.unit == line_unit_percent ? widths.height_px / 100.0 : 1.0;
  return line.width * unit * class_width(placed.line_class) * placed.share;
}
