// SPDX-License-Identifier: MIT
// How wide a placed line is, by all but its distance. Needs lib/placed.glsl.
#include "generated/line.glsl"
#include "lib/class_width.glsl"

// In pixels, for widths in pixels or percent.
float even_width(Placed placed) {
  float unit = line.unit == line_unit_percent ? widths.height_px / 100.0 : 1.0;
  return line.width * unit * class_width(placed.line_class) * placed.share;
}
