#version 450 core
// SPDX-License-Identifier: MIT
// How much of each pixel its nearest line covers, for lines so narrow that looking at all pixels around is cheaper than a
// flood. Tiles without a line in reach are left out at once.
#include "lib/lens.glsl"
#include "lib/placed.glsl"

uniform sampler2D placed_map;
uniform sampler2D tile_map;  // a texel for 8 x 8 pixels: above 0 where one has a line
uniform sampler2D normal_and_depth_map;
uniform sampler2D visible_map;
layout(location = 0) out vec2 ink;  // coverage, class / 255

#include "lib/line_width.glsl"
#include "lib/pieces.glsl"

vec4 seed_of(ivec2 at, vec4 texel) {
  Placed line = unpacked_line(texel);
  float width = line_width(line, at);
  return width > 0.0 ? vec4(vec2(at) + 0.5 + line.offset, 0.5 * width, line.line_class) : vec4(0.0);
}

vec4 texel_at(ivec2 at) {
  ivec2 size = textureSize(placed_map, 0);
  bool is_inside = all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, size));
  return is_inside ? texelFetch(placed_map, at, 0) : vec4(0.0);
}

bool has_line_near(ivec2 at) {
  ivec2 last = textureSize(tile_map, 0) - 1;
  ivec2 low = max((at - coverage.reach_px) / 8, ivec2(0)), high = min((at + coverage.reach_px) / 8, last);
  return texelFetch(tile_map, low, 0).r + texelFetch(tile_map, high, 0).r + texelFetch(tile_map, ivec2(low.x, high.y), 0).r +
             texelFetch(tile_map, ivec2(high.x, low.y), 0).r > 0.0;
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  int side = 2 * coverage.reach_px + 1;
  int taps = has_line_near(at) ? side * side : 0;  // a loop without turns costs nothing
  vec4 nearest = vec4(0.0);
  float least = 1e30;
  for (int i = 0; i < taps; ++i) {
    ivec2 there = at + ivec2(i % side, i / side) - coverage.reach_px;
    vec4 texel = texel_at(there);
    int turns = is_placed(texel) ? 1 : 0;
    for (int turn = 0; turn < turns; ++turn) {
      vec4 seed = seed_of(there, texel);
      float ends = distance(seed.xy, gl_FragCoord.xy) - seed.z;
      if (seed.a > 0.5 && ends < least) {
        least = ends;
        nearest = seed;
      }
    }
  }
  int turns = nearest.a > 0.5 && least < 2.5 ? 1 : 0;
  ink = vec2(0.0);
  for (int turn = 0; turn < turns; ++turn) {
    vec4 around[9];
    for (int i = 0; i < 9; ++i) {
      ivec2 there = ivec2(floor(nearest.xy)) + ivec2(i % 3, i / 3) - 1;
      vec4 texel = texel_at(there);
      around[i] = is_placed(texel) ? seed_of(there, texel) : vec4(0.0);
    }
    ink = ink_of(at, gl_FragCoord.xy, nearest, around);
  }
}
