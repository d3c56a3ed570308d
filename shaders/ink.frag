#version 450 core
// SPDX-License-Identifier: MIT
// Where there is a line of the paper's, the combined edges not zero, the ink replaces the shading (3.5).
#include "generated/ink.glsl"
#include "lib/ink.glsl"

uniform sampler2D shaded_map;
uniform sampler2D drawn_map;
layout(location = 0) out vec4 colour;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  bool inked = is_line(ink_coverage(texelFetch(drawn_map, at, 0), true));
  colour = inked ? vec4(ink.colour, 1.0) : texelFetch(shaded_map, at, 0);
}
