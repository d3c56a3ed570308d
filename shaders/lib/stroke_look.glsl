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

// Over white. Where classes overlap the earlier one is on top; together they hide as much as the one that hides most, so
// that what goes over from class to class shows no seam. `surface`: a colour for all, where `is_of_surface`.
vec4 over_white(ivec2 at, vec3 surface, bool is_of_surface) {
  vec4 shares[3] = vec4[3](texelFetch(first_classes, at, 0), texelFetch(next_classes, at, 0), texelFetch(last_classes, at, 0));
  vec3 colour = vec3(0.0);
  float hidden = 0.0;
  for (int i = 0; i < 12; ++i) {
    float share = shares[i / 4][i % 4] * look.of_class[i].a;
    float added = max(share - hidden, 0.0);
    colour += added * (is_of_surface ? surface * (1.0 - look.darken) : look.of_class[i].rgb);
    hidden += added;
  }
  return vec4(colour + 1.0 - hidden, hidden);
}
