#version 450 core
// SPDX-License-Identifier: MIT
// The pixels that own a line, and where in them it runs: a crease where its planes meet, a step half a pixel inside the
// nearer surface.
#include "generated/edges.glsl"
#include "lib/lens.glsl"
#include "lib/surface.glsl"
#include "lib/pair.glsl"
#include "lib/dihedral.glsl"

uniform sampler2D surface_map;
layout(location = 0) out vec4 placed;  // offset from the pixel's centre in pixels, class (0: no line), strength

// So many pixels along a step each way decide where it runs.
const int smooth_reach = 2;
const float most_offset = 0.499;

bool is_line(Side side) { return side.strength >= edges.weak; }
bool is_step(Side side) { return is_line(side) && side.line_class <= class_silhouette; }
bool is_crease(Side side) { return is_line(side) && side.line_class > class_silhouette; }

// Where the planes of the pixel and of its neighbour meet, in pixels from its centre.
float crossing(ivec2 at, ivec2 towards) {
  vec4 a = texelFetch(surface_map, at, 0), b = texelFetch(surface_map, at + towards, 0);
  vec2 along = vec2(towards);
  Misfit apart = misfit(a, b, dot(a.xy, along), dot(b.xy, along));
  float sum = abs(apart.at_a) + abs(apart.at_b);
  return sum > 0.0 ? min(abs(apart.at_a) / sum, most_offset) : most_offset;
}

// The creases to the right, left, above and below, as points on both axes: x and y of where they cross them, and whether.
vec4 crease_crossings(ivec2 at, Sides sides) {
  vec4 result = vec4(0.0);
  int right = is_crease(sides.right) ? 1 : 0, left = is_crease(sides.left) ? 1 : 0;
  int above = is_crease(sides.above) ? 1 : 0, below = is_crease(sides.below) ? 1 : 0;
  for (int turn = 0; turn < right; ++turn) result.xz += vec2(crossing(at, ivec2(1, 0)), 1.0);
  for (int turn = 0; turn < left; ++turn) result.xz += vec2(-crossing(at, ivec2(-1, 0)), 1.0);
  for (int turn = 0; turn < above; ++turn) result.yw += vec2(crossing(at, ivec2(0, 1)), 1.0);
  for (int turn = 0; turn < below; ++turn) result.yw += vec2(-crossing(at, ivec2(0, -1)), 1.0);
  return vec4(result.xy / max(result.zw, 1.0), min(result.zw, 1.0));
}

// The foot of the perpendicular from the pixel's centre to the line through both points, or the one point there is.
vec2 foot_of(vec4 crossings) {
  vec2 square = crossings.xy * crossings.xy;
  float sum = square.x + square.y;
  if (crossings.z < 0.5 || crossings.w < 0.5) return crossings.xy;
  return sum > 0.0 ? crossings.xy * square.yx / sum : vec2(0.0);
}

// Does a step run between the pixel and the one `across` (an axis' direction), with the line on the pixel's side?
bool has_step(ivec2 at, ivec2 across) {
  ivec2 first = min(at, at + across), last = textureSize(pair_map, 0) - 1;
  if (any(lessThan(first, ivec2(0))) || any(greaterThan(max(at, at + across), last))) return false;
  vec4 pair = texelFetch(pair_map, first, 0);
  vec2 bend_and_gap = across.x != 0 ? pair.xz : pair.yw;
  return is_step(side_of(bend_and_gap.x, bend_and_gap.y, first == at ? 1.0 : -1.0, edges.weak));
}

// How far `across` the step goes on one pixel further along, from `height`: none where it ends.
const float ends = 100.0;
float next_height(ivec2 at, ivec2 across, float height) {
  for (int i = 0; i < 3; ++i) {
    float tried = height + float(i == 0 ? 0 : 3 - 2 * i);
    if (has_step(at + int(tried) * across, across)) return tried;
  }
  return ends;
}

// The mean height of the step over as many pixels on both sides as it has, `across` its direction.
float smooth_height(ivec2 at, ivec2 across) {
  ivec2 along = ivec2(abs(across.y), abs(across.x));
  float sum = 0.0, count = 1.0, before = 0.0, after = 0.0;
  for (int i = 1; i <= smooth_reach; ++i) {
    before = next_height(at - i * along, across, before);
    after = next_height(at + i * along, across, after);
    if (before == ends || after == ends) break;
    sum += before + after;
    count += 2.0;
  }
  return clamp(sum / count, -most_offset, most_offset);
}

vec2 step_offset(ivec2 at, Sides sides) {
  bool right = is_step(sides.right), left = is_step(sides.left), above = is_step(sides.above), below = is_step(sides.below);
  if ((right || left) && (above || below)) return vec2(0.0);
  if (right != left) return vec2(smooth_height(at, ivec2(right ? 1 : -1, 0)) * (right ? 1.0 : -1.0), 0.0);
  if (above != below) return vec2(0.0, smooth_height(at, ivec2(0, above ? 1 : -1)) * (above ? 1.0 : -1.0));
  return vec2(0.0);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  Sides sides = sides_of(at, edges.weak);
  float line_class = class_of(sides, edges.weak), strength = strongest(sides);
  bool has_steps = line_class > class_none && line_class <= class_silhouette, has_creases = line_class > class_silhouette;
  vec2 offset = vec2(0.0);
  int steps = has_steps ? 1 : 0, creases = has_creases ? 1 : 0;  // loops without turns cost nothing
  for (int turn = 0; turn < steps; ++turn) offset = step_offset(at, sides);
  for (int turn = 0; turn < creases; ++turn) offset = foot_of(crease_crossings(at, sides));
  placed = line_class > class_none ? vec4(offset, line_class, strength) : vec4(0.0);
}
