#version 450 core
// SPDX-License-Identifier: MIT
// Strokes of charcoal: coarse grain that the paper's hills take on, crumbling edges, dust.
#include "lib/capsule.glsl"
#include "lib/stroke_block.glsl"
#include "lib/touch.glsl"

float painted(Touch touch) {
  float unit = strokes.length_px / 64.0;
  vec2 place = vec2(touch.along, touch.foot.aside) / unit;
  float paper = 0.4 * noise_at(place / 1.25, touch.seed) + 0.35 * noise_at(place / 2.7, touch.seed + 1u) +
                0.25 * noise_at(place / vec2(16.0, 5.0), touch.seed + 2u);
  float press = noise_at(vec2(repetition_at(touch) * 1.3, 2.5), touch.seed + 3u);
  float rim = clamp((touch.foot.inside + 0.5) / (0.75 * touch.foot.radius + 0.8), 0.0, 1.0);
  float limit = strokes.grain * (1.3 - 0.65 * rim - 0.25 * press);
  float coal = smoothstep(limit - 0.17, limit + 0.17, paper + 0.06);
  float dust = 0.35 * rim * strokes.grain * (0.5 + press);
  return solid_share(touch.foot) * mix(dust, 0.72 + 0.28 * press, coal);
}

#include "lib/stroke_segment.glsl"
