// SPDX-License-Identifier: MIT
// How wide a placed line is. Needs lib/lens.glsl, lib/placed.glsl and the samplers normal_and_depth_map and visible_map, which
// are read only where the width depends on the distance.
#include "generated/line.glsl"

layout(std140) uniform widths_block {
  vec4 of_class[2];  // times the width: object, silhouette, crease, normal | shadow, material
  float height_px;
} widths;

float class_width(float line_class) {
  int i = int(line_class + 0.5) - 1;
  return widths.of_class[i / 4][i % 4];
}

// What the distance makes of the width.
float distance_factor(ivec2 at) {
  float away = texelFetch(normal_and_depth_map, at, 0).a * lens.far;
  vec2 visible = texelFetch(visible_map, ivec2(0), 0).rg;  // nearest, farthest
  float how_far = clamp((away - visible.x) / max(visible.y - visible.x, 1e-30), 0.0, 1.0);
  float factor = 1.0 - line.depth_taper * how_far;
  if (line.unit == line_unit_world) factor /= lens.is_orthographic != 0 ? lens.pixel_size : lens.pixel_size * away;
  return factor;
}

// In pixels.
float line_width(Placed placed, ivec2 at) {
  float width = line.width * class_width(placed.line_class) * placed.share;
  if (line.unit == line_unit_percent) width *= widths.height_px / 100.0;
  int turns = line.unit == line_unit_world || line.depth_taper > 0.0 ? 1 : 0;
  for (int turn = 0; turn < turns; ++turn) width *= distance_factor(at);
  return width;
}
