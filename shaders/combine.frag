#version 450 core
// SPDX-License-Identifier: MIT
// p = min(((gmax - gmin) / k)^2, 1) of each edge type, their sum against the threshold (3.4.4).
#include "generated/combine.glsl"

uniform sampler2D range_map;
layout(location = 0) out float edge;  // 0: no line; else the sum of both terms, at most 1

void main() {
  vec2 range = texelFetch(range_map, ivec2(gl_FragCoord.xy), 0).rg;
  vec2 ratio = range / vec2(combine.k_depth, combine.k_normal);
  vec2 p = min(ratio * ratio, 1.0) * vec2(combine.use_depth, combine.use_normal);
  float sum = p.x + p.y;
  edge = sum < combine.threshold ? 0.0 : min(sum, 1.0);
}
