#version 450 core
// SPDX-License-Identifier: MIT
// How much of each pixel its nearest line covers, for lines so narrow that looking at all pixels around is cheaper than a
// flood. Drawn over the tiles with a line in reach alone.
#include "lib/lens.glsl"
#include "lib/placed.glsl"

uniform sampler2D placed_map;
uniform sampler2D tile_map;  // a texel for 8 x 8 pixels: above 0 where one has a line
uniform sampler2D normal_and_depth_map;
layout(location = 0) out vec2 ink;  // coverage, class / 255

#include "lib/line_width.glsl"

vec4 seed_at(ivec2 at) {
  ivec2 place = clamp(at, ivec2(0), textureSize(placed_map, 0) - 1);
  vec4 texel = texelFetch(placed_map, place, 0);
  Placed line = unpacked_line(texel);
  float width = even_width(line);
  bool is_seed = place == at && is_placed(texel) && width > 0.0;
  return vec4(vec2(at) + 0.5 + line.offset, 0.5 * width, is_seed ? line.line_class : 0.0);
}

#include "lib/pieces.glsl"
#include "lib/tiles.glsl"

float coverage_of(vec2 here, vec4 from, int found, int rows) {
  Foot foot = nearest_foot(here, from, found, rows);
  return coverage.samples == 0 ? exact_share(foot) : float(foot.away <= foot.half_width);
}

#include "lib/ink_of_line.glsl"

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  int reach = has_line_in(at - coverage.reach_px, at + coverage.reach_px) ? coverage.reach_px : -1;
  vec4 nearest = vec4(0.0);
  float least = 1e30;
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      vec4 seed = seed_at(at + ivec2(dx, dy));
      float ends = seed.a > 0.5 ? distance(seed.xy, gl_FragCoord.xy) - seed.z : 1e30;
      bool is_nearer = ends < least;
      least = is_nearer ? ends : least;
      nearest = is_nearer ? seed : nearest;
    }
  }
  ink = ink_of(at, nearest, least < farthest_beyond);
}
