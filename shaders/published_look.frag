#version 450 core
// SPDX-License-Identifier: MIT
// Ink as Decaudin's and Saito and Takahashi's detectors draw it: half at the limit and full at twice the limit.

uniform sampler2D detection_map;  // strength
uniform sampler2D class_map;
layout(location = 0) out vec2 ink;  // coverage, class / 255

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  ink = vec2(min(texelFetch(detection_map, at, 0).r / 2.0, 1.0), texelFetch(class_map, at, 0).r / 255.0);
}
