// SPDX-License-Identifier: MIT
// A line as the pieces between the points of linked pixels, and the share of a pixel that it covers. A seed is a line's
// point in pixels from the lower left corner, half the line's width there, and its class, 0 where there is none. Needs
// `vec4 seed_at(ivec2 at)` of pixels that have one. Of the 3 x 3 pixels around one a word has a bit each: bit x + 8 y.

layout(std140) uniform coverage_block {
  int samples;  // a side: in or out at so many by so many points of a pixel; 0: the exact share
  int padding;
  uvec2 within;  // of the 8 x 8 pixels from the third to the left and below on, those whose line can matter (lib/line_bits.glsl)
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

// Which of the neighbours of a line's pixel it goes on to, of those `around` it that have a line: diagonal ones where neither
// pixel beside both has one.
uint links_of(uint around) {
  uint beside = (around >> 1 & 0x10001u) | (around << 1 & 0x40004u) | (around >> 8 & 0x5u) | (around << 8 & 0x50000u);
  return around & (0x20502u | 0x50005u & ~beside);
}

// Of the pieces that begin at the nearest point; of the point itself where there is none.
Foot nearest_foot(vec2 here, vec4 from, uint links) {
  ivec2 corner = ivec2(floor(from.xy)) - 1;
  Foot nearest = foot_on(here, from, from);
  float least = 1e30;
  while (links != 0u) {
    int i = findLSB(links);
    links &= links - 1u;
    Foot foot = foot_on(here, from, seed_at(corner + ivec2(i & 7, i >> 3)));
    float beyond = foot.away - foot.half_width;
    bool is_nearer = beyond < least;
    least = is_nearer ? beyond : least;
    nearest.away = is_nearer ? foot.away : nearest.away;
    nearest.direction = is_nearer ? foot.direction : nearest.direction;
    nearest.half_width = is_nearer ? foot.half_width : nearest.half_width;
  }
  return nearest;
}

float exact_share(Foot foot) {
  return share_before(foot.half_width - foot.away, foot.direction) - share_before(-foot.half_width - foot.away, foot.direction);
}
