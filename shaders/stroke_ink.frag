#version 450 core
// SPDX-License-Identifier: MIT
// Strokes as ink: the largest coverage of a class, and which that is.

uniform sampler2D first_classes;
uniform sampler2D next_classes;
uniform sampler2D last_classes;
layout(std140) uniform stroke_ink_block {
  vec4 edge_class[3];  // of each class of curves
} classes;
layout(location = 0) out vec2 ink;  // coverage, class / 255

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 shares[3] = vec4[3](texelFetch(first_classes, at, 0), texelFetch(next_classes, at, 0), texelFetch(last_classes, at, 0));
  ink = vec2(0.0);
  for (int i = 0; i < 12; ++i) {
    float share = shares[i / 4][i % 4];
    if (share > ink.r) ink = vec2(share, classes.edge_class[i / 4][i % 4] / 255.0);
  }
}
