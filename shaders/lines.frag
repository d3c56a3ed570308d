#version 450 core
// SPDX-License-Identifier: MIT
// The lines as they are measured: 1 where a pixel is one.
#include "lib/line.glsl"

uniform sampler2D edge_map;
layout(location = 0) out float line;

void main() { line = is_line(texelFetch(edge_map, ivec2(gl_FragCoord.xy), 0).r) ? 1.0 : 0.0; }
