#version 450 core
// SPDX-License-Identifier: MIT
// The filter's ink and the strokes': what covers more.
#include "lib/ink.glsl"

uniform sampler2D filter_map;
uniform sampler2D stroke_map;
layout(std140) uniform both_inks_block {
  int is_papers;
} inks;
layout(location = 0) out vec2 ink;  // coverage, class / 255

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  bool is_papers = inks.is_papers != 0;
  vec4 drawn = texelFetch(filter_map, at, 0), stroke = texelFetch(stroke_map, at, 0);
  float coverage = ink_coverage(drawn, is_papers);
  ink = coverage > stroke.r ? vec2(coverage, is_papers ? 0.0 : drawn.g) : stroke.rg;
}
