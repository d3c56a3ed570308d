#version 450 core
// SPDX-License-Identifier: MIT
// Pairs of neighbours with the angles between the normals that light sees, in place of the triangles' or the larger of
// both. Between two objects there is no angle.
#include "lib/chord.glsl"
#include "lib/pair_map.glsl"

uniform sampler2D pair_map;
uniform sampler2D normal_and_depth_map;
layout(std140) uniform shaded_pairs_block {
  int keeps_surface;
} wanted;
layout(location = 0) out vec4 pairs;

// Where no model is all have the same.
vec3 normal_at(ivec2 at) {
  vec3 normal = 2.0 * texelFetch(normal_and_depth_map, at, 0).xyz - 1.0;
  return dot(normal, normal) > 0.25 ? normalize(normal) : vec3(0.0, 0.0, 1.0);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(pair_map, 0) - 1;
  vec4 own = texelFetch(pair_map, at, 0);
  vec3 here = normal_at(at);
  vec2 chords = vec2(square_of_chord(here, normal_at(min(at + ivec2(1, 0), last))),
                     square_of_chord(here, normal_at(min(at + ivec2(0, 1), last))));
  vec2 bends = max(degrees_of_chord(chords), abs(own.xy) * float(wanted.keeps_surface));
  bends = mix(bends, vec2(0.0), greaterThan(abs(own.zw), vec2(largest_gap)));
  pairs = vec4(mix(bends, -bends, lessThan(own.xy, vec2(0.0))), own.zw);
}
