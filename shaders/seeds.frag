#version 450 core
// SPDX-License-Identifier: MIT
// Placed lines as seeds: each pixel of a line knows its own point and half its width.
#include "lib/lens.glsl"
#include "lib/placed.glsl"

uniform sampler2D placed_map;
uniform sampler2D normal_and_depth_map;
uniform sampler2D visible_map;  // 1 x 1: nearest and farthest distance
layout(location = 0) out vec4 seed;  // the line's point in pixels from the lower left corner, half its width in pixels, class (0: none)

#include "lib/line_width.glsl"

// What the distance makes of the width.
float distance_factor(ivec2 at) {
  float away = texelFetch(normal_and_depth_map, at, 0).a * lens.far;
  vec2 visible = texelFetch(visible_map, ivec2(0), 0).rg;  // nearest, farthest
  float how_far = clamp((away - visible.x) / max(visible.y - visible.x, 1e-30), 0.0, 1.0);
  float unit = lens.is_orthographic != 0 ? lens.pixel_size : lens.pixel_size * away;
  return (1.0 - line.depth_taper * how_far) / (line.unit == line_unit_world ? unit : 1.0);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 texel = texelFetch(placed_map, at, 0);
  Placed line = unpacked_line(texel);
  float width = is_placed(texel) ? even_width(line) : 0.0;
  if (widths.need_distance != 0) width *= distance_factor(at);
  seed = width > 0.0 ? vec4(gl_FragCoord.xy + line.offset, 0.5 * width, line.line_class) : vec4(0.0);
}
