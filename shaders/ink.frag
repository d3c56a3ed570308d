#version 450 core
// SPDX-License-Identifier: MIT
// Where the combined edges are not zero the ink replaces the shading (3.5).
#include "generated/ink.glsl"

uniform sampler2D shaded_map;
uniform sampler2D edge_map;
layout(location = 0) out vec4 colour;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  bool inked = texelFetch(edge_map, at, 0).r > 0.0;
  colour = inked ? vec4(ink.colour, 1.0) : texelFetch(shaded_map, at, 0);
}
