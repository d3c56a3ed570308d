#version 450 core
// SPDX-License-Identifier: MIT
// The normal and depth maps as an eight-bit framebuffer stores them; the target's format does the rounding.

uniform sampler2D normal_and_depth_map;
layout(location = 0) out vec4 normal_and_depth;

void main() {
  normal_and_depth = texelFetch(normal_and_depth_map, ivec2(gl_FragCoord.xy), 0);
}
