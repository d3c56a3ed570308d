#version 450 core
// SPDX-License-Identifier: MIT
// Strokes over a picture, as much as they hide.

uniform sampler2D below_map;
uniform sampler2D stroke_map;  // colour over white; how much is hidden
layout(location = 0) out vec4 colour;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 strokes = texelFetch(stroke_map, at, 0), below = texelFetch(below_map, at, 0);
  colour = strokes.a <= 0.0 ? below : vec4(below.rgb * (1.0 - strokes.a) + strokes.rgb - (1.0 - strokes.a), 1.0);
}
