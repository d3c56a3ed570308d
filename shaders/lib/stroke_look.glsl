// SPDX-License-Identifier: MIT
// The classes' coverage on one pixel, and what they look like one over the other.

uniform sampler2D first_classes;
uniform sampler2D next_classes;
uniform sampler2D last_classes;
layout(std140) uniform stroke_look_block {
  vec4 of_class[12];  // colour and opacity
  float darken;
  float reach_px;  // so far a surface gives a stroke beside it its colour
} look;

// Classes together hide as much as the one that hides most, so that what goes over from class to class shows no seam.
float hidden_at(ivec2 at) {
  vec4 first = texelFetch(first_classes, at, 0) * vec4(look.of_class[0].a, look.of_class[1].a, look.of_class[2].a, look.of_class[3].a);
  vec4 next = texelFetch(next_classes, at, 0) * vec4(look.of_class[4].a, look.of_class[5].a, look.of_class[6].a, look.of_class[7].a);
  vec4 last = texelFetch(last_classes, at, 0) * vec4(look.of_class[8].a, look.of_class[9].a, look.of_class[10].a, look.of_class[11].a);
  vec4 most = max(max(first, next), last);
  return max(max(most.x, most.y), max(most.z, most.w));
}

// In one colour, over white.
vec4 over_white(ivec2 at, vec3 colour) {
  float hidden = hidden_at(at);
  return vec4(hidden * colour + 1.0 - hidden, hidden);
}
