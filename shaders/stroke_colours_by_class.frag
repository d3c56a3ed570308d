#version 450 core
// SPDX-License-Identifier: MIT
// Strokes in their classes' colours, over white. Where classes overlap the earlier one is on top.
#include "lib/stroke_look.glsl"

layout(location = 0) out vec4 colour;  // alpha: how much of what lies below is hidden

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 shares[3] = vec4[3](texelFetch(first_classes, at, 0), texelFetch(next_classes, at, 0), texelFetch(last_classes, at, 0));
  vec3 sum = vec3(0.0);
  float hidden = 0.0;
  for (int i = 0; i < 12; ++i) {
    float added = max(shares[i / 4][i % 4] * look.of_class[i].a - hidden, 0.0);
    sum += added * look.of_class[i].rgb;
    hidden += added;
  }
  colour = vec4(sum + 1.0 - hidden, hidden);
}
