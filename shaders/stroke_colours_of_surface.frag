#version 450 core
// SPDX-License-Identifier: MIT
// Strokes in the colours of the surfaces that they lie on, darkened, over white. Half of an outline lies beside its
// object: it takes the colour of the nearest surface around.
#include "lib/stroke_look.glsl"

uniform sampler2D colour_map;
uniform sampler2D normal_and_depth_map;
uniform sampler2D object_id_map;
layout(location = 0) out vec4 colour;  // alpha: how much of what lies below is hidden

// Around a pixel, each twice as far as the one before.
const int rings = 3;
const vec2 ways[8] = vec2[8](vec2(1, 0), vec2(0.7, 0.7), vec2(0, 1), vec2(-0.7, 0.7), vec2(-1, 0), vec2(-0.7, -0.7), vec2(0, -1), vec2(0.7, -0.7));

ivec2 place_of(ivec2 at, int i) {
  float away = look.reach_px * float(1 << ((i + 7) / 8)) / float(1 << rings);
  ivec2 place = i == 0 ? at : at + ivec2(round(away * ways[(i - 1) % 8]));
  return clamp(place, ivec2(0), textureSize(colour_map, 0) - 1);
}

// Mean colour of the object that is nearest to the eye among the places around.
vec3 surface_colour(ivec2 at) {
  float nearest = 2.0, id = 0.0;
  for (int i = 0; i <= 8 * rings; ++i) {
    ivec2 place = place_of(at, i);
    float depth = texelFetch(normal_and_depth_map, place, 0).a;
    id = depth < nearest ? texelFetch(object_id_map, place, 0).r : id;
    nearest = min(depth, nearest);
  }
  vec4 sum = vec4(0.0);
  for (int i = 0; i <= 8 * rings; ++i) {
    ivec2 place = place_of(at, i);
    float counts = texelFetch(object_id_map, place, 0).r == id ? 1.0 / float(1 << ((i + 7) / 8)) : 0.0;
    sum += counts * vec4(texelFetch(colour_map, place, 0).rgb, 1.0);
  }
  return sum.rgb / sum.a;
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  colour = over_white(at, surface_colour(at) * (1.0 - look.darken));
}
