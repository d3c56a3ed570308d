#version 450 core
// SPDX-License-Identifier: MIT
// Ink as Mitchell's detector draws it: its pixels dilated by 3 x 3, each with the class of the strongest around.

uniform sampler2D detection_map;  // strength
uniform sampler2D class_map;
layout(location = 0) out vec2 ink;  // coverage, class / 255

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(detection_map, 0) - 1;
  float strongest = texelFetch(detection_map, at, 0).r;
  ivec2 strongest_at = at;
  for (int i = 0; i < 9; ++i) {
    ivec2 place = clamp(at + ivec2(i % 3, i / 3) - 1, ivec2(0), last);
    float there = texelFetch(detection_map, place, 0).r;
    if (there > strongest) {
      strongest = there;
      strongest_at = place;
    }
  }
  ink = vec2(strongest >= 1.0 ? 1.0 : 0.0, texelFetch(class_map, strongest_at, 0).r / 255.0);
}
