#version 450 core
// SPDX-License-Identifier: MIT
// Strokes as a technical pen draws them.
#include "lib/capsule.glsl"
#include "lib/stroke_block.glsl"
#include "lib/touch.glsl"

float painted(Touch touch) { return solid_share(touch.foot); }

#include "lib/stroke_segment.glsl"
