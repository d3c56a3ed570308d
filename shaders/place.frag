#version 450 core
// SPDX-License-Identifier: MIT
// Thinned candidates as placed lines: the offset is to the middle of the strengths of the candidates around.
#include "lib/placed.glsl"

uniform sampler2D detection_map;  // strength
uniform sampler2D class_map;
uniform sampler2D candidate_map;
uniform sampler2D thinned_map;
layout(location = 0) out vec4 placed;  // lib/placed.glsl

// What is far above the limit counts no more than this: a step's strength has no upper end.
const float most_weight = 4.0;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  bool is_line = texelFetch(thinned_map, at, 0).r > 0.5;
  vec2 sum = vec2(0.0);
  float weights = 0.0;
  int taps = is_line ? 9 : 0;
  for (int i = 0; i < taps; ++i) {
    ivec2 d = ivec2(i % 3, i / 3) - 1;
    ivec2 there = clamp(at + d, ivec2(0), textureSize(detection_map, 0) - 1);
    float weight = texelFetch(candidate_map, there, 0).r * min(texelFetch(detection_map, there, 0).r, most_weight);
    sum += weight * vec2(d);
    weights += weight;
  }
  vec2 offset = clamp(sum / max(weights, 1e-6), -0.499, 0.499);
  float line_class = is_line ? texelFetch(class_map, at, 0).r : 0.0;
  placed = packed_line(Placed(offset, line_class, texelFetch(detection_map, at, 0).r));
}
