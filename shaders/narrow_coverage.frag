#version 450 core
// SPDX-License-Identifier: MIT
// How much of each pixel its nearest line covers, for lines so narrow that looking at all lines around is cheaper than a
// flood. Drawn over the tiles with a line in reach alone.
#include "lib/lens.glsl"
#include "lib/placed.glsl"

uniform sampler2D placed_map;
uniform usampler2D bit_map;
uniform sampler2D normal_and_depth_map;
layout(location = 0) out vec2 ink;  // coverage, class / 255

#include "lib/line_bits.glsl"
#include "lib/line_width.glsl"

// Of a pixel that has a line.
vec4 seed_at(ivec2 at) {
  Placed line = unpacked_line(texelFetch(placed_map, at, 0));
  return vec4(vec2(at) + 0.5 + line.offset, 0.5 * even_width(line), line.line_class);
}

uint seeds_around(ivec2 of_line, bool is_asked) { return is_asked ? bits_from(of_line - 1).x : 0u; }

#include "lib/pieces.glsl"

float coverage_of(vec2 here, vec4 from, uint links) {
  Foot foot = nearest_foot(here, from, links);
  return coverage.samples == 0 ? exact_share(foot) : float(foot.away <= foot.half_width);
}

#include "lib/ink_of_line.glsl"

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 nearest = vec4(0.0);
  float least = 1e29;  // of the squared distance less the squared half width: no root, and the wider of two lines is nearer
  uvec2 bits = bits_from(at - 3) & coverage.within;
  while ((bits.x | bits.y) != 0u) {
    bool is_low = bits.x != 0u;
    uint rows = is_low ? bits.x : bits.y;
    int first = findLSB(rows);
    rows &= rows - 1u;
    bits = is_low ? uvec2(rows, bits.y) : uvec2(0u, rows);
    vec4 seed = seed_at(at + ivec2(first & 7, (first >> 3) + (is_low ? 0 : 4)) - 3);
    vec2 away = seed.xy - gl_FragCoord.xy;
    float power = dot(away, away) - seed.z * seed.z;
    bool is_nearer = power < least;
    least = is_nearer ? power : least;
    nearest = is_nearer ? seed : nearest;
  }
  ink = ink_of(at, nearest, nearest.a > 0.5 && distance(nearest.xy, gl_FragCoord.xy) < nearest.z + farthest_beyond);
}
