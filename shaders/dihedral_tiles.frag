#version 450 core
// SPDX-License-Identifier: MIT
// Which tiles of 8 x 8 pixels have a pixel of a pair that reaches a limit.
#include "generated/dihedral.glsl"
#include "generated/edges.glsl"

uniform sampler2D largest_map;  // angle and gap
layout(location = 0) out float has_line;

void main() {
  vec2 largest = texelFetch(largest_map, ivec2(gl_FragCoord.xy), 0).rg / vec2(dihedral.angle, dihedral.gap);
  has_line = max(largest.x, largest.y) >= edges.weak ? 1.0 : 0.0;
}
