#version 450 core
// SPDX-License-Identifier: MIT
// How much of each pixel its nearest line covers, where a flood has found which line that is.
#include "lib/lens.glsl"

uniform sampler2D seed_map;
uniform sampler2D normal_and_depth_map;
layout(location = 0) out vec2 ink;  // coverage, class / 255

vec4 seed_at(ivec2 at) {
  ivec2 place = clamp(at, ivec2(0), textureSize(seed_map, 0) - 1);
  vec4 seed = texelFetch(seed_map, place, 0);
  return place == at && seed.a > 0.5 && ivec2(floor(seed.xy)) == at ? seed : vec4(0.0);
}

vec4 seed_nearby(ivec2 at) { return seed_at(at); }

bool has_seed(ivec2 at) { return seed_at(at).a > 0.5; }

#include "lib/pieces.glsl"

float coverage_of(vec2 here, vec4 from, int found, int rows) {
  if (coverage.samples == 0) return exact_share(nearest_foot(here, from, found, rows));
  int inside = 0;
  for (int s = 0; s < coverage.samples * coverage.samples; ++s) {
    vec2 place = (vec2(s % coverage.samples, s / coverage.samples) + 0.5) / float(coverage.samples) - 0.5;
    Foot foot = nearest_foot(here + place, from, found, rows);
    inside += int(foot.away <= foot.half_width);
  }
  return float(inside) / float(coverage.samples * coverage.samples);
}

#include "lib/ink_of_line.glsl"

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 nearest = texelFetch(seed_map, at, 0);
  ink = ink_of(at, nearest, nearest.a > 0.5 && distance(nearest.xy, gl_FragCoord.xy) < nearest.z + farthest_beyond);
}
