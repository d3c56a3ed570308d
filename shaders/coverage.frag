#version 450 core
// SPDX-License-Identifier: MIT
// How much of each pixel its nearest line covers. A line is the pieces between the points of linked pixels.
#include "lib/lens.glsl"

uniform sampler2D seed_map;  // the nearest line's point, half its width, class
uniform sampler2D normal_and_depth_map;
layout(std140) uniform coverage_block {
  int samples;  // a side: in or out at so many by so many points of a pixel; 0: the exact share
} coverage;
layout(location = 0) out vec2 ink;  // coverage, class

// The share of a pixel on the near side of a straight edge `to_edge` pixels from its centre; `slope` is the absolute
// direction to the edge, a unit vector. Exact.
float share_before(float to_edge, vec2 slope) {
  float a = max(slope.x, slope.y), b = max(min(slope.x, slope.y), 1e-4);
  float flat_end = 0.5 * (a - b), end = 0.5 * (a + b), t = abs(to_edge);
  float beyond = t >= end ? 0.0 : t <= flat_end ? 0.5 - t / a : (end - t) * (end - t) / (2.0 * a * b);
  return to_edge > 0.0 ? 1.0 - beyond : beyond;
}

// Where a piece of a line is nearest: how far away, in which direction, and half its width there.
struct Foot {
  float away;
  vec2 direction;  // absolute
  float half_width;
};

// Of the piece from `a` to `b`, which become `half_a` and `half_b` wide.
Foot foot_on(vec2 here, vec2 a, vec2 b, float half_a, float half_b) {
  vec2 along = b - a;
  float t = clamp(dot(here - a, along) / max(dot(along, along), 1e-12), 0.0, 1.0);
  vec2 off = here - (a + t * along);
  float away = length(off);
  vec2 direction = away > 1e-4 ? abs(off) / away : abs(normalize(vec2(-along.y, along.x) + vec2(1e-12, 0.0)));
  return Foot(away, direction, mix(half_a, half_b, t));
}

float exact_coverage(vec2 here, vec4 from, vec4 ends[9]) {
  Foot nearest = Foot(1e30, vec2(1.0, 0.0), 0.0);
  for (int i = 0; i < 9; ++i) {
    if (ends[i].a < 0.5) continue;
    Foot foot = foot_on(here, from.xy, ends[i].xy, from.z, ends[i].z);
    if (foot.away - foot.half_width < nearest.away - nearest.half_width) nearest = foot;
  }
  return share_before(nearest.half_width - nearest.away, nearest.direction) -
         share_before(-nearest.half_width - nearest.away, nearest.direction);
}

bool is_in_piece(vec2 here, vec2 a, vec2 b, float half_a, float half_b) {
  vec2 along = b - a;
  float t = clamp(dot(here - a, along) / max(dot(along, along), 1e-12), 0.0, 1.0);
  return distance(here, a + t * along) <= mix(half_a, half_b, t);
}

vec4 seed_at(ivec2 at) {
  bool is_inside = all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, textureSize(seed_map, 0)));
  vec4 seed = texelFetch(seed_map, clamp(at, ivec2(0), textureSize(seed_map, 0) - 1), 0);
  return is_inside && seed.a > 0.5 && ivec2(floor(seed.xy)) == at ? seed : vec4(0.0);
}

float depth_at(ivec2 at) {
  return texelFetch(normal_and_depth_map, clamp(at, ivec2(0), textureSize(normal_and_depth_map, 0) - 1), 0).a;
}

// Does the pixel show a surface in front of the line's? One that goes on from the line's own comes nearer no more than
// three times as fast as it does here.
bool is_in_front(ivec2 at, ivec2 of_line) {
  float own = depth_at(at), lines = depth_at(of_line);
  if (is_background(own) || own >= lines) return false;
  float here = affine_depth(own);
  vec2 before = vec2(affine_depth(depth_at(at - ivec2(1, 0))), affine_depth(depth_at(at - ivec2(0, 1))));
  vec2 after = vec2(affine_depth(depth_at(at + ivec2(1, 0))), affine_depth(depth_at(at + ivec2(0, 1))));
  vec2 slope = min(abs(before - here), abs(after - here));
  float explained = dot(slope, abs(vec2(at - of_line)));
  return in_pixel_sizes(max(abs(here - affine_depth(lines)) - 3.0 * explained, 0.0), here) > 2.0;
}

// The points of the pieces that begin at the line's pixel: 0 where there is none.
void find_pieces(ivec2 of_line, out vec4 ends[9]) {
  vec4 around[9];
  bool alone = true;
  for (int i = 0; i < 9; ++i) around[i] = seed_at(of_line + ivec2(i % 3, i / 3) - 1);
  for (int i = 0; i < 9; ++i) {
    ivec2 d = ivec2(i % 3, i / 3) - 1;
    bool beside_both = around[4 + d.x].a > 0.5 || around[4 + 3 * d.y].a > 0.5;
    bool linked = i != 4 && around[i].a > 0.5 && (d.x * d.y == 0 || !beside_both);
    ends[i] = linked ? around[i] : vec4(0.0);
    alone = alone && !linked;
  }
  if (alone) ends[4] = around[4];  // a point
}

float sampled_coverage(vec2 corner, vec4 from, vec4 ends[9]) {
  int inside = 0;
  for (int s = 0; s < coverage.samples * coverage.samples; ++s) {
    vec2 place = vec2(s % coverage.samples, s / coverage.samples) + 0.5;
    bool is_in = false;
    for (int i = 0; i < 9; ++i)
      is_in = is_in || (ends[i].a > 0.5 && is_in_piece(corner + place / float(coverage.samples), from.xy, ends[i].xy, from.z, ends[i].z));
    inside += int(is_in);
  }
  return float(inside) / float(coverage.samples * coverage.samples);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec2 here = gl_FragCoord.xy;
  vec4 nearest = texelFetch(seed_map, at, 0);
  bool is_close = nearest.a > 0.5 && distance(nearest.xy, here) < nearest.z + 2.5;
  ivec2 of_line = ivec2(floor(nearest.xy));
  int turns = is_close ? 1 : 0;  // a loop without turns costs nothing
  float covered = 0.0;
  for (int turn = 0; turn < turns; ++turn) {
    vec4 ends[9];
    find_pieces(of_line, ends);
    covered = coverage.samples > 0 ? sampled_coverage(vec2(at), nearest, ends) : exact_coverage(here, nearest, ends);
    if (covered > 0.0 && is_in_front(at, of_line)) covered = 0.0;
  }
  ink = vec2(covered, covered > 0.0 ? nearest.a : 0.0);
}
