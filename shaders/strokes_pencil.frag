#version 450 core
// SPDX-License-Identifier: MIT
// Strokes of a pencil: graphite on the grain of the paper, softer towards the edges.
#include "lib/capsule.glsl"
#include "lib/stroke_block.glsl"
#include "lib/touch.glsl"

float painted(Touch touch) {
  float unit = strokes.length_px / 64.0;
  vec2 place = vec2(touch.along, touch.foot.aside) / unit;
  float paper = 0.6 * noise_at(place / 1.3, touch.seed) + 0.4 * noise_at(place / 2.9, touch.seed + 1u);
  float pressure = 0.65 + 0.35 * noise_at(vec2(repetition_at(touch), 5.5), touch.seed + 2u);
  float soft = clamp((touch.foot.inside + 0.5) / (0.35 * touch.foot.radius + 1.0), 0.0, 1.0);
  float limit = strokes.grain * (1.25 - 0.75 * pressure * soft);
  return solid_share(touch.foot) * pressure * mix(1.0, soft, 0.5) * smoothstep(limit - 0.25, limit + 0.25, paper + 0.1);
}

#include "lib/stroke_segment.glsl"
