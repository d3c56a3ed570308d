#version 450 core
// SPDX-License-Identifier: MIT
// Placed lines as seeds: each pixel of a line knows its own point and half its width.
#include "lib/lens.glsl"
#include "lib/line_width.glsl"

uniform sampler2D placed_map;
uniform sampler2D normal_and_depth_map;
uniform sampler2D visible_map;  // 1 x 1: nearest and farthest distance
layout(location = 0) out vec4 seed;  // the line's point in pixels from the lower left corner, half its width in pixels, class (0: none)

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 placed = texelFetch(placed_map, at, 0);
  bool is_line = placed.b > 0.5;
  float depth = texelFetch(normal_and_depth_map, at, 0).a;
  vec2 visible = texelFetch(visible_map, ivec2(0), 0).rg;
  float width = is_line ? line_width(placed, depth, visible) : 0.0;
  seed = width > 0.0 ? vec4(gl_FragCoord.xy + placed.rg, 0.5 * width, placed.b) : vec4(0.0);
}
