#version 450 core
// SPDX-License-Identifier: MIT
// Decaudin's gradients: the first-order operator on the depth map and on each component of the normal map.
#include "lib/operators.glsl"

uniform sampler2D normal_and_depth_map;
layout(location = 0) out vec4 gradient;  // of the normal's x, y and z, of the depth

void main() { gradient = first_order(normal_and_depth_map, ivec2(gl_FragCoord.xy)); }
