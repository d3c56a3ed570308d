#version 450 core
// SPDX-License-Identifier: MIT
// The sum of both terms (3.4.4) over the threshold, and the class of the pixels that reach it.
#include "generated/combine.glsl"

uniform sampler2D range_map;
layout(location = 0) out vec2 edge;  // strength, class

#include "lib/edge_class.glsl"

// A threshold of 0 lets any sum through.
const float without_threshold = 1e-30;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec2 ratio = texelFetch(range_map, at, 0).rg / vec2(combine.k_depth, combine.k_normal);
  vec2 p = min(ratio * ratio, 1.0) * vec2(combine.use_depth, combine.use_normal);
  float sum = p.x + p.y;
  float strength = sum / max(combine.threshold, without_threshold);
  edge = vec2(strength, sum > 0.0 && sum >= combine.threshold ? class_of_surfaces(2) : class_none);
}
