#version 450 core
// SPDX-License-Identifier: MIT
// How much of each pixel its nearest line covers, where a flood has found which line that is.
#include "lib/lens.glsl"

uniform sampler2D seed_map;
uniform sampler2D normal_and_depth_map;
layout(location = 0) out vec2 ink;  // coverage, class / 255

#include "lib/pieces.glsl"

vec4 seed_at(ivec2 at) {
  bool is_inside = all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, textureSize(seed_map, 0)));
  vec4 seed = texelFetch(seed_map, clamp(at, ivec2(0), textureSize(seed_map, 0) - 1), 0);
  return is_inside && seed.a > 0.5 && ivec2(floor(seed.xy)) == at ? seed : vec4(0.0);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 nearest = texelFetch(seed_map, at, 0);
  bool is_close = nearest.a > 0.5 && distance(nearest.xy, gl_FragCoord.xy) < nearest.z + 2.5;
  int turns = is_close ? 1 : 0;  // a loop without turns costs nothing
  ink = vec2(0.0);
  for (int turn = 0; turn < turns; ++turn) {
    vec4 around[9];
    for (int i = 0; i < 9; ++i) around[i] = seed_at(ivec2(floor(nearest.xy)) + ivec2(i % 3, i / 3) - 1);
    ink = ink_of(at, gl_FragCoord.xy, nearest, around);
  }
}
