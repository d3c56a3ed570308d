#version 450 core
// SPDX-License-Identifier: MIT
// Strokes in one colour, over white.
#include "lib/stroke_look.glsl"

layout(location = 0) out vec4 colour;  // alpha: how much of what lies below is hidden

void main() { colour = over_white(ivec2(gl_FragCoord.xy), look.of_class[0].rgb); }
