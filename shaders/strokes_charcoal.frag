#version 450 core
// SPDX-License-Identifier: MIT
// Strokes of charcoal: coarse grain that the paper's hills take on, crumbling edges, dust.
#include "lib/capsule.glsl"
#include "lib/stroke_block.glsl"
#include "lib/touch.glsl"

float painted(Touch touch) {
  float unit = strokes.length_px / 64.0;
  vec2 place = vec2(touch.along, touch.foot.aside) / unit;
  float paper = 0.45 * noise_at(place / 1.6, touch.seed) + 0.35 * noise_at(place / 3.7, touch.seed + 1u) +
                0.2 * noise_at(place / vec2(11.0, 5.0), touch.seed + 2u);
  float rim = clamp((touch.foot.inside + 0.5) / (0.6 * touch.foot.radius + 0.8), 0.0, 1.0);
  float limit = strokes.grain * (1.15 - 0.6 * rim);
  float coal = smoothstep(limit - 0.12, limit + 0.12, paper + 0.08);
  float dust = 0.18 * rim * strokes.grain;
  return solid_share(touch.foot) * max(coal * mix(0.75, 1.0, paper), dust);
}

#include "lib/stroke_segment.glsl"
