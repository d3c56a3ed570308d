// SPDX-License-Identifier: MIT
// How wide a placed line is. Needs lib/lens.glsl.
#include "generated/line.glsl"

layout(std140) uniform widths_block {
  vec4 of_class[2];  // times the width: object, silhouette, crease, normal | shadow, material
  float height_px;
} widths;

float class_width(float line_class) {
  int i = int(line_class + 0.5) - 1;
  return widths.of_class[i / 4][i % 4];
}

// In pixels; `placed` as pipeline/passes/placing/placed_lines.h says, `depth` of its pixel, `visible` the nearest and the
// farthest distance.
float line_width(vec4 placed, float depth, vec2 visible) {
  float distance = depth * lens.far;
  float width = line.width;
  if (line.unit == line_unit_percent) width *= widths.height_px / 100.0;
  if (line.unit == line_unit_world) width /= lens.is_orthographic != 0 ? lens.pixel_size : lens.pixel_size * distance;
  float how_far = clamp((distance - visible.x) / max(visible.y - visible.x, 1e-30), 0.0, 1.0);
  return width * class_width(placed.b) * min(placed.a, 1.0) * (1.0 - line.depth_taper * how_far);
}
