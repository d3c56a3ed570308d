#version 450 core
// SPDX-License-Identifier: MIT
// Saito and Takahashi's profiles, by the first-order operator, and creases, by the second-order one, whose strength has a
// limiter.
#include "generated/edges.glsl"
#include "generated/saito_takahashi.glsl"

uniform sampler2D visible_depth_map;
layout(location = 0) out vec2 edge;  // strength, class

#include "lib/edge_class.glsl"
#include "lib/operators.glsl"

// A step is many times a crease: without this its second order would outshine what the first says.
const float most_of_a_crease = 2.0;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  ivec2 size = textureSize(visible_depth_map, 0);
  ivec2 centre = operator_centre(at, size);
  ivec2 low = max(centre - 1, ivec2(0)), high = min(centre + 1, size - 1);
#define DEPTH(place) texelFetch(visible_depth_map, place, 0).r
  float a = DEPTH(low), b = DEPTH(ivec2(centre.x, low.y)), c = DEPTH(ivec2(high.x, low.y));
  float d = DEPTH(ivec2(low.x, centre.y)), x = DEPTH(centre), e = DEPTH(ivec2(high.x, centre.y));
  float f = DEPTH(ivec2(low.x, high.y)), g = DEPTH(ivec2(centre.x, high.y)), h = DEPTH(high);
  float profile = (abs(a + 2.0 * b + c - f - 2.0 * g - h) + abs(c + 2.0 * e + h - a - 2.0 * d - f)) / 8.0;
  float crease = abs(8.0 * x - (a + b + c + d + e + f + g + h)) / 3.0;
  float strength = max(profile / saito_takahashi.profile, min(crease / saito_takahashi.crease, most_of_a_crease));
  edge = vec2(strength, strength >= edges.weak ? class_of_surfaces(1) : class_none);
}
