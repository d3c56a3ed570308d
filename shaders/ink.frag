#version 450 core
// SPDX-License-Identifier: MIT
// Where there is a line, the combined edges not zero, the ink replaces the shading (3.5).
#include "generated/ink.glsl"
#include "lib/line.glsl"

uniform sampler2D shaded_map;
uniform sampler2D edge_map;
layout(location = 0) out vec4 colour;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  bool inked = is_line(texelFetch(edge_map, at, 0).r);
  colour = inked ? vec4(ink.colour, 1.0) : texelFetch(shaded_map, at, 0);
}
