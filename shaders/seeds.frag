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

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 texel = texelFetch(placed_map, at, 0);
  Placed line = unpacked_line(texel);
  float width = is_placed(texel) ? line_width(line, at) : 0.0;
  seed = width > 0.0 ? vec4(gl_FragCoord.xy + line.offset, 0.5 * width, line.line_class) : vec4(0.0);
}
