#version 450 core
// SPDX-License-Identifier: MIT
// How much of each pixel its nearest line covers, for lines so narrow that looking at all pixels around is cheaper than a
// flood. Drawn over the tiles with a line in reach alone.
#include "lib/lens.glsl"
#include "lib/placed.glsl"

uniform sampler2D placed_map;
uniform sampler2D normal_and_depth_map;
layout(location = 0) out vec2 ink;  // coverage, class / 255

#include "lib/line_width.glsl"

// Outside the image that of the nearest pixel in it, where that is found anyway.
vec4 seed_nearby(ivec2 at) {
  ivec2 place = clamp(at, ivec2(0), textureSize(placed_map, 0) - 1);
  Placed line = unpacked_line(texelFetch(placed_map, place, 0));
  float width = even_width(line);
  return vec4(vec2(place) + 0.5 + line.offset, 0.5 * width, width > 0.0 ? line.line_class : 0.0);
}

bool has_seed(ivec2 at) {
  ivec2 place = clamp(at, ivec2(0), textureSize(placed_map, 0) - 1);
  vec4 texel = texelFetch(placed_map, place, 0);
  return place == at && is_placed(texel) && class_width(floor(texel.b * 255.0 + 0.5)) * texel.a > 0.0;
}

#include "lib/pieces.glsl"

float coverage_of(vec2 here, vec4 from, int found, int rows) {
  Foot foot = nearest_foot(here, from, found, rows);
  return coverage.samples == 0 ? exact_share(foot) : float(foot.away <= foot.half_width);
}

#include "lib/ink_of_line.glsl"

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  int reach = coverage.reach_px;
  vec4 nearest = vec4(0.0);
  float least = 1e29;  // of the squared distance less the squared half width: no root, and the wider of two lines is nearer
  for (int dy = -reach; dy <= reach; ++dy) {
    // No point of a pixel beyond this can be the nearest of a line that touches this one.
    float rise = max(abs(float(dy)) - 0.5, 0.0);
    int span = int(sqrt(max(coverage.farthest * coverage.farthest - rise * rise, 0.0)) + 0.5);
    for (int dx = -span; dx <= span; ++dx) {
      vec4 seed = seed_nearby(at + ivec2(dx, dy));
      vec2 away = seed.xy - gl_FragCoord.xy;
      float power = dot(away, away) - seed.z * seed.z + (seed.a > 0.5 ? 0.0 : 1e30);
      bool is_nearer = power < least;
      least = is_nearer ? power : least;
      nearest = is_nearer ? seed : nearest;
    }
  }
  ink = ink_of(at, nearest, nearest.a > 0.5 && distance(nearest.xy, gl_FragCoord.xy) < nearest.z + farthest_beyond);
}
