#version 450 core
// SPDX-License-Identifier: MIT
// Ink over the shading, as much as it covers, in its class's colour and opacity.
#include "generated/ink.glsl"
#include "lib/ink.glsl"

uniform sampler2D shaded_map;
uniform sampler2D drawn_map;  // coverage, class / 255
layout(std140) uniform look_block {
  vec4 of_class[6];  // colour and opacity: object, silhouette, crease, normal, shadow, material
  int has_colours;   // else all take ink.colour
} look;
layout(location = 0) out vec4 colour;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 drawn = texelFetch(drawn_map, at, 0);
  vec4 shaded = texelFetch(shaded_map, at, 0);
  int place = clamp(int(drawn.g * 255.0 + 0.5) - 1, 0, 5);
  float hides = ink_coverage(drawn, false) * look.of_class[place].a;
  vec3 line_colour = look.has_colours == 0 ? ink.colour : look.of_class[place].rgb;
  colour = hides >= 1.0 ? vec4(line_colour, 1.0) : hides <= 0.0 ? shaded : mix(shaded, vec4(line_colour, 1.0), hides);
}
