#version 450 core
// SPDX-License-Identifier: MIT
// Strokes of a brush full of ink: solid with a slightly uneven edge, and split into the bristles' tracks where it runs
// dry.
#include "lib/capsule.glsl"
#include "lib/stroke_block.glsl"
#include "lib/touch.glsl"

float painted(Touch touch) {
  float unit = strokes.length_px / 64.0;
  float uneven = noise_at(vec2(touch.along / (7.0 * unit), sign(touch.across)), touch.seed) - 0.5;
  float share = clamp(touch.foot.inside + 0.35 * uneven * min(touch.foot.radius, 2.0) + 0.5, 0.0, min(1.0, 2.0 * touch.foot.radius));
  float dry = strokes.is_stretched != 0 ? repetition_at(touch) : noise_at(vec2(repetition_at(touch), 3.5), touch.seed);
  float bristles = clamp(touch.foot.radius / unit, 1.0, 12.0);
  float track = noise_at(vec2(repetition_at(touch) * 2.0, touch.across * bristles + 40.0), touch.seed + 1u);
  float fine = noise_at(vec2(touch.along / (5.0 * unit), touch.across * bristles * 2.0 + 40.0), touch.seed + 2u);
  float ink = 0.75 * track + 0.25 * fine;
  float limit = strokes.grain * (1.6 * dry - 0.55);
  return share * smoothstep(limit - 0.08, limit + 0.08, ink);
}

#include "lib/stroke_segment.glsl"
