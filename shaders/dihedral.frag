#version 450 core
// SPDX-License-Identifier: MIT
// Strength and class of the strongest of a pixel's four sides.
#include "generated/edges.glsl"
#include "lib/dihedral.glsl"

layout(location = 0) out vec2 edge;  // strength, class

void main() {
  Sides sides = sides_of(ivec2(gl_FragCoord.xy), edges.weak);
  edge = vec2(strongest(sides), class_of(sides, edges.weak));
}
