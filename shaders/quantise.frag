#version 450 core
// SPDX-License-Identifier: MIT
// The normal and depth maps as a smaller G-buffer stores them. To eight bits the target's format rounds.
#include "lib/stored.glsl"

uniform sampler2D normal_and_depth_map;
layout(location = 0) out vec4 normal_and_depth;

void main() {
  vec4 exact = texelFetch(normal_and_depth_map, ivec2(gl_FragCoord.xy), 0);
  vec3 normal = half_float(2.0 * exact.xyz - 1.0);
  normal_and_depth = stored.format == format_unorm8 ? exact : vec4(0.5 * normal + 0.5, stored_depth(exact.w));
}
