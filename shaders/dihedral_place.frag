#version 450 core
// SPDX-License-Identifier: MIT
// The pixels that own a line, and where in them it runs: a crease where its planes meet, a step half a pixel inside the
// nearer surface.
#include "generated/edges.glsl"
#include "lib/dihedral.glsl"
#include "lib/placed.glsl"

layout(location = 0) out vec4 placed;  // lib/placed.glsl

// So many pixels along a step each way decide where it runs.
const int smooth_reach = 2;
const float most_offset = 0.499;

bool is_line(Side side) { return side.strength >= edges.weak; }
bool is_step(Side side) { return is_line(side) && side.line_class <= class_silhouette; }
bool is_crease(Side side) { return is_line(side) && side.line_class > class_silhouette; }

// Where the creases on the pixel's sides cross its axes, x and y, and whether any does.
vec4 crease_crossings(Sides sides) {
  vec4 is_there = vec4(is_crease(sides.right), is_crease(sides.above), is_crease(sides.left), is_crease(sides.below));
  vec4 away = min(vec4(sides.right.meets, sides.above.meets, sides.left.meets, sides.below.meets), most_offset) * is_there;
  vec2 count = is_there.xy + is_there.zw;
  return vec4((away.xy - away.zw) / max(count, 1.0), min(count, 1.0));
}

// The foot of the perpendicular from the pixel's centre to the line through both points, or the one point there is.
vec2 foot_of(vec4 crossings) {
  vec2 square = crossings.xy * crossings.xy;
  float sum = square.x + square.y;
  if (crossings.z < 0.5 || crossings.w < 0.5) return crossings.xy;
  return sum > 0.0 ? crossings.xy * square.yx / sum : vec2(0.0);
}

// Of a pair.
bool is_gap(float gap) { return abs(gap) > meeting_gap && abs(gap) >= edges.weak * dihedral.gap; }

// Does a step run between the pixel and the one `across` (an axis' direction), with the line on the pixel's side?
bool has_step(ivec2 at, ivec2 across) {
  ivec2 first = min(at, at + across), last = textureSize(pair_map, 0) - 1;
  if (any(lessThan(first, ivec2(0))) || any(greaterThan(max(at, at + across), last))) return false;
  vec4 pair = texelFetch(pair_map, first, 0);
  float gap = across.x != 0 ? pair.z : pair.w;
  return is_gap(gap) && (first == at) == (gap > 0.0);
}

// The height of the step in the pixels from two before it to two after it, or as few on both sides as it has: the mean.
// `across` is the step's direction; `pixels` is 4, or 0 for no work.
float smooth_height(ivec2 at, ivec2 across, int pixels) {
  vec4 heights = vec4(0.0);  // 1 and 2 before, 1 and 2 after
  vec4 has = vec4(0.0);
  float height = 0.0, goes_on = 1.0;
  for (int i = 0; i < pixels; ++i) {
    ivec2 along = (i < 2 ? -1 - i : i - 1) * ivec2(abs(across.y), abs(across.x));
    if (i == 2) height = 0.0, goes_on = 1.0;
    float tried = height, found = 0.0;
    int tries = goes_on > 0.5 ? 3 : 0;
    for (int k = 0; k < tries; ++k) {  // as high, one higher, one lower
      if (has_step(at + along + int(tried) * across, across)) {
        height = tried;
        found = 1.0;
        break;
      }
      tried = k == 0 ? height + 1.0 : height - 1.0;
    }
    goes_on = found;
    heights = vec4(heights.yzw, height);
    has = vec4(has.yzw, found);
  }
  vec2 both = has.xy * has.zw;  // 1 and 2 pixels away
  return clamp(dot(heights.xy + heights.zw, both) / (1.0 + 2.0 * (both.x + both.y)), -most_offset, most_offset);
}

// 1 or -1 along the one axis on which the pixel has a step on one side; where it has them on both axes it is a corner or
// the line is a diagonal, which runs through the pixels' middles.
ivec2 step_direction(Sides sides) {
  ivec2 direction = ivec2(int(is_step(sides.right)) - int(is_step(sides.left)), int(is_step(sides.above)) - int(is_step(sides.below)));
  bool has_both = (is_step(sides.right) || is_step(sides.left)) && (is_step(sides.above) || is_step(sides.below));
  return has_both ? ivec2(0) : direction;
}

// Is the pixel, from `at`, one of the eight around it?
bool is_around(ivec2 away) { return away != ivec2(0) && all(lessThanEqual(abs(away), ivec2(1))); }

// Whose line the pair is, from the pixel whose pair it is: it, the other pixel `towards`, or none, which is far away.
ivec2 owner_of(float angle, float gap, ivec2 towards) {
  float which = is_gap(gap) ? gap : abs(angle) >= edges.weak * dihedral.angle ? angle : 0.0;
  return which > 0.0 ? ivec2(0) : which < 0.0 ? towards : ivec2(100);
}

// Does a line go through any of the eight pixels around? `pairs` is 16, or 0 for no work.
bool has_company(ivec2 at, int pairs) {
  bool found = false;
  for (int i = 0; i < pairs; ++i) {
    ivec2 from = ivec2(i % 4, i / 4) - 2;
    ivec2 there = clamp(at + from, ivec2(0), textureSize(pair_map, 0) - 1);
    vec4 pair = texelFetch(pair_map, there, 0);
    found = found || is_around(there - at + owner_of(pair.x, pair.z, ivec2(1, 0))) ||
            is_around(there - at + owner_of(pair.y, pair.w, ivec2(0, 1)));
  }
  return found;
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  Sides sides = sides_of(at, edges.weak);
  float line_class = class_of(sides, edges.weak), strength = strongest(sides);
  bool has_steps = line_class > class_none && line_class <= class_silhouette, has_creases = line_class > class_silhouette;
  vec2 offset = vec2(0.0);
  // A loop that no lane enters runs once on the software renderer, so its body is small.
  ivec2 across = has_steps ? step_direction(sides) : ivec2(0);
  offset = vec2(across) * smooth_height(at, across, across != ivec2(0) ? 4 : 0);
  offset = has_creases ? foot_of(crease_crossings(sides)) : offset;
  bool is_dot = !has_company(at, line_class > class_none ? 16 : 0);  // a single pixel is no line
  placed = packed_line(Placed(offset, is_dot ? class_none : line_class, strength));
}
