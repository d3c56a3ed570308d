#version 450 core
// SPDX-License-Identifier: MIT
// The lines as they are measured, and the coverage that decides them.
#include "lib/ink.glsl"

uniform sampler2D drawn_map;
layout(std140) uniform lines_block {
  int is_papers;
} lines;
layout(location = 0) out vec2 line;  // 1 where a pixel is one, else 0; coverage

void main() {
  float coverage = ink_coverage(texelFetch(drawn_map, ivec2(gl_FragCoord.xy), 0), lines.is_papers != 0);
  line = vec2(is_line(coverage) ? 1.0 : 0.0, coverage);
}
