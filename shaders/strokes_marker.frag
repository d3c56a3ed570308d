#version 450 core
// SPDX-License-Identifier: MIT
// Strokes of a felt marker: even and a little transparent, darker where ink gathers at the edges and ends.
#include "lib/capsule.glsl"
#include "lib/stroke_block.glsl"
#include "lib/touch.glsl"

float painted(Touch touch) {
  float unit = strokes.length_px / 64.0;
  float streak = noise_at(vec2(repetition_at(touch), touch.across * 3.0 + 40.0), touch.seed);
  float edge = 1.0 - smoothstep(0.0, 1.6 * unit, touch.foot.inside - 0.2 * unit);
  float body = 1.0 - strokes.grain * (0.55 + 0.25 * (streak - 0.5));
  return solid_share(touch.foot) * mix(body, 1.0, 0.75 * edge);
}

#include "lib/stroke_segment.glsl"
