#version 450 core
// SPDX-License-Identifier: MIT
// Ink as the published detectors draw it: half at the limit and full at twice the limit; Mitchell's dilates its pixels by
// 3 x 3.
#include "generated/edges.glsl"

uniform sampler2D detection_map;  // strength, class
layout(location = 0) out vec2 ink;  // coverage, class / 255

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec2 here = texelFetch(detection_map, at, 0).rg;
  ivec2 last = textureSize(detection_map, 0) - 1;
  bool dilates = edges.method == edges_method_mitchell;
  int turns = dilates ? 9 : 0;  // a loop without turns costs nothing
  vec2 strongest = here;
  for (int i = 0; i < turns; ++i) {
    vec2 there = texelFetch(detection_map, clamp(at + ivec2(i % 3, i / 3) - 1, ivec2(0), last), 0).rg;
    if (there.r > strongest.r) strongest = there;
  }
  float coverage = dilates ? (strongest.r >= 1.0 ? 1.0 : 0.0) : min(here.r / 2.0, 1.0);
  ink = vec2(coverage, strongest.g / 255.0);
}
