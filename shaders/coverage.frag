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

uint seeds_around(ivec2 of_line, bool is_asked) {
  uint around = 0u;
  int rows = is_asked ? 3 : 0;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < 3; ++x) around |= seed_at(of_line + ivec2(x, y) - 1).a > 0.5 ? 1u << (8 * y + x) : 0u;
  return around;
}

#include "lib/pieces.glsl"

float coverage_of(vec2 here, vec4 from, uint links) {
  if (coverage.samples == 0) return exact_share(nearest_foot(here, from, links));
  int inside = 0;
  for (int s = 0; s < coverage.samples * coverage.samples; ++s) {
    vec2 place = (vec2(s % coverage.samples, s / coverage.samples) + 0.5) / float(coverage.samples) - 0.5;
    Foot foot = nearest_foot(here + place, from, links);
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
