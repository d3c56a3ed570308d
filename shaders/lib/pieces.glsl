// SPDX-License-Identifier: MIT
// A line as the pieces between the points of linked pixels, and the share of a pixel that it covers. A seed is a line's
// point in pixels from the lower left corner, half the line's width there, and its class, 0 where there is none. Needs
// lib/lens.glsl and the sampler normal_and_depth_map.

layout(std140) uniform coverage_block {
  int samples;  // a side: in or out at so many by so many points of a pixel; 0: the exact share
  int reach_px;  // how far from a pixel its line's point can be
} coverage;

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

Foot foot_on(vec2 here, vec4 from, vec4 to) {
  vec2 along = to.xy - from.xy;
  float t = clamp(dot(here - from.xy, along) / max(dot(along, along), 1e-12), 0.0, 1.0);
  vec2 off = here - (from.xy + t * along);
  float away = length(off);
  vec2 direction = away > 1e-4 ? abs(off) / away : abs(normalize(vec2(-along.y, along.x) + vec2(1e-12, 0.0)));
  return Foot(away, direction, mix(from.z, to.z, t));
}

// The seeds around a line's pixel (itself at 4) become the ends of the pieces that begin there: diagonal neighbours count
// where neither pixel beside both has a line; a pixel alone is a point.
void keep_linked(inout vec4 seeds[9]) {
  bool side[9];
  for (int i = 0; i < 9; ++i) side[i] = seeds[i].a > 0.5;
  bool alone = true;
  for (int i = 0; i < 9; ++i) {
    ivec2 d = ivec2(i % 3, i / 3) - 1;
    bool linked = i != 4 && side[i] && (d.x * d.y == 0 || !(side[4 + d.x] || side[4 + 3 * d.y]));
    alone = alone && !linked;
    if (!linked && i != 4) seeds[i] = vec4(0.0);
  }
  if (!alone) seeds[4].a = 0.0;
}

float exact_coverage(vec2 here, vec4 from, vec4 ends[9]) {
  Foot nearest = Foot(1e30, vec2(1.0, 0.0), 0.0);
  for (int i = 0; i < 9; ++i) {
    if (ends[i].a < 0.5) continue;
    Foot foot = foot_on(here, from, ends[i]);
    if (foot.away - foot.half_width < nearest.away - nearest.half_width) nearest = foot;
  }
  return share_before(nearest.half_width - nearest.away, nearest.direction) -
         share_before(-nearest.half_width - nearest.away, nearest.direction);
}

float sampled_coverage(vec2 here, vec4 from, vec4 ends[9]) {
  int inside = 0;
  for (int s = 0; s < coverage.samples * coverage.samples; ++s) {
    vec2 place = (vec2(s % coverage.samples, s / coverage.samples) + 0.5) / float(coverage.samples) - 0.5;
    bool is_in = false;
    for (int i = 0; i < 9; ++i) {
      Foot foot = foot_on(here + place, from, ends[i]);
      is_in = is_in || (ends[i].a > 0.5 && foot.away <= foot.half_width);
    }
    inside += int(is_in);
  }
  return float(inside) / float(coverage.samples * coverage.samples);
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

// Coverage and class / 255 of the pixel whose centre is `here`, by its nearest seed and the seeds around that one.
vec2 ink_of(ivec2 at, vec2 here, vec4 nearest, vec4 around[9]) {
  keep_linked(around);
  float covered = coverage.samples > 0 ? sampled_coverage(here, nearest, around) : exact_coverage(here, nearest, around);
  if (covered > 0.0 && is_in_front(at, ivec2(floor(nearest.xy)))) covered = 0.0;
  return vec2(covered, covered > 0.0 ? nearest.a / 255.0 : 0.0);
}
