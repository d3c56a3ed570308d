#version 450 core
// SPDX-License-Identifier: MIT
// Strokes of a felt marker: even and a little transparent, darker where ink gathers at the edges and ends.
#include "lib/capsule.glsl"
#include "lib/stroke_block.glsl"
#include "lib/touch.glsl"

float painted(Touch touch) {
  float unit = strokes.length_px / 64.0;
  float streak = noise_at(vec2(repetition_at(touch), touch.across * 3.0 + 40.0), touch.seed);
  float felt = noise_at(vec2(touch.along, touch.foot.aside) / (2.2 * unit), touch.seed + 1u);
  float gathered = exp(-max(touch.foot.inside, 0.0) / (1.8 * unit));
  float left_out = strokes.grain * clamp(0.62 + 0.3 * (streak - 0.5) + 0.12 * (felt - 0.5) - 0.3 * gathered, 0.0, 1.0);
  return solid_share(touch.foot) * (1.0 - left_out);
}

#include "lib/stroke_segment.glsl"
