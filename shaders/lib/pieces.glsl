// SPDX-License-Identifier: MIT
// A line as the pieces between the points of linked pixels, and the share of a pixel that it covers. A seed is a line's
// point in pixels from the lower left corner, half the line's width there, and its class, 0 where there is none. Needs
// `bool has_seed(ivec2 at)` and, of pixels that have one, `vec4 seed_nearby(ivec2 at)`.

layout(std140) uniform coverage_block {
  int samples;  // a side: in or out at so many by so many points of a pixel; 0: the exact share
  int reach_px;  // how far from a pixel the pixel of its line's nearest point can be, along a row or column
  float farthest;  // how far from its centre that point can be
} coverage;

// A pixel that a line touches lies no farther beyond the line's half width from the line's nearest point: its corner is 0.71
// from its centre, and points are 1.5 apart at most.
const float farthest_beyond = 1.1;

// The share of a pixel on the near side of a straight edge `to_edge` pixels from its centre; `slope` is the absolute
// direction to the edge, a unit vector. Exact.
float share_before(float to_edge, vec2 slope) {
  float a = max(slope.x, slope.y), b = max(min(slope.x, slope.y), 1e-4);
  float flat_end = 0.5 * (a - b), end = 0.5 * (a + b), t = abs(to_edge);
  float beyond = t >= end ? 0.0 : t <= flat_end ? 0.5 - t / a : (end - t) * (end - t) / (2.0 * a * b);
  return to_edge > 0.0 ? 1.0 - beyond : beyond;
}

// Where a line is nearest: how far away, in which direction, and half its width there.
struct Foot {
  float away;
  vec2 direction;  // absolute
  float half_width;
};

Foot foot_on(vec2 here, vec4 from, vec4 to) {
  vec2 along = to.xy - from.xy;
  float t = clamp(dot(here - from.xy, along) / max(dot(along, along), 1e-12), 0.0, 1.0);
  vec2 off = here - (from.xy + t * along);
  float away = length(off);
  vec2 direction = away > 1e-4 ? abs(off) / away : abs(normalize(vec2(-along.y, along.x) + vec2(1e-12, 0.0)));
  return Foot(away, direction, mix(from.z, to.z, t));
}

ivec2 step_of(int i) { return ivec2(i % 3, i / 3) - 1; }

// Which of the eight neighbours of a line's pixel have a line, a bit each.
int seeds_around(ivec2 of_line, int rows) {
  int found = 0;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < 3; ++x) found |= has_seed(of_line + ivec2(x, y) - 1) ? 1 << (3 * y + x) : 0;
  return found & ~16;
}

// Diagonal neighbours count where neither pixel beside both has a line.
bool is_linked(int found, int i) {
  ivec2 d = step_of(i);
  bool beside_both = (found & (1 << (4 + d.x) | 1 << (4 + 3 * d.y))) != 0;
  return (found & 1 << i) != 0 && (d.x * d.y == 0 || !beside_both);
}

// Of the pieces that begin at the nearest point; of the point itself where there is none.
Foot nearest_foot(vec2 here, vec4 from, int found, int rows) {
  Foot nearest = foot_on(here, from, from);
  bool alone = true;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < 3; ++x) {
      Foot foot = foot_on(here, from, seed_nearby(ivec2(floor(from.xy)) + ivec2(x, y) - 1));
      bool is_nearer = is_linked(found, 3 * y + x) && (alone || foot.away - foot.half_width < nearest.away - nearest.half_width);
      alone = alone && !is_nearer;
      nearest.away = is_nearer ? foot.away : nearest.away;
      nearest.direction = is_nearer ? foot.direction : nearest.direction;
      nearest.half_width = is_nearer ? foot.half_width : nearest.half_width;
    }
  }
  return nearest;
}

float exact_share(Foot foot) {
  return share_before(foot.half_width - foot.away, foot.direction) - share_before(-foot.half_width - foot.away, foot.direction);
}
