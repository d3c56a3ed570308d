// SPDX-License-Identifier: MIT
// Two neighbouring pixels' planes against each other (docs/pipeline.md, dihedral). Needs lib/lens.glsl and
// lib/surface.glsl.
#include "lib/pair_map.glsl"
#include "lib/chord.glsl"

// A depth as the G-buffer holds it is off by no more than this share of it.
const float depth_error = 1e-6;

struct Plane {
  vec4 surface;   // lib/surface.glsl
  vec3 normal;    // unit
  float upright;  // how far off the plane a point is that lies 1 farther along the view
};

Plane plane_at(vec4 surface, vec2 from_middle) {
  vec2 ray = ray_through(from_middle);
  vec3 normal = surface_normal(surface, ray);
  float scale = inversesqrt(dot(normal, normal));
  return Plane(surface, normal * scale, scale);
}

// Of a's plane over b's, along the view in pixels' sizes.
struct Misfit {
  float at_a, at_b;
};

// `t_a` and `t_b` are their t in the direction from a to b.
Misfit misfit(vec4 a, vec4 b, float t_a, float t_b) {
  float apart = (b.z - a.z) / lens.pixel_size;
  if (lens.is_orthographic != 0) return Misfit(apart + t_b, apart + t_a);
  float ratio = b.z / a.z;
  return Misfit(apart / b.z + t_b / ratio, apart / a.z + t_a * ratio);
}

// What depth's digits leave open, in pixels' sizes.
float misfit_error(float distance) {
  return depth_error * (lens.is_orthographic != 0 ? distance : 1.0) / lens.pixel_size;
}

// Angle and gap of the pair, below 0 where the line is b's: a step's is the nearer surface's, a crease's
// lies where the planes meet.
vec2 pair_of(Plane a, Plane b, Misfit apart, float bend) {
  if (a.surface.w == 0.0 && b.surface.w == 0.0) return vec2(0.0);
  bool a_is_nearer = b.surface.w == 0.0 || (a.surface.w != 0.0 && a.surface.z <= b.surface.z);
  if (a.surface.w != b.surface.w) return vec2(0.0, a_is_nearer ? object_gap : -object_gap);
  float at_a = abs(apart.at_a), at_b = abs(apart.at_b);
  bool they_meet = apart.at_a * apart.at_b <= 0.0;
  float gap = min(at_b * a.upright, at_a * b.upright) - misfit_error(a.surface.z);
  if (they_meet || !(gap > meeting_gap)) {
    float share = at_a / max(at_a + at_b, 1e-30);
    gap = meeting_gap * clamp(share, 0.0, 1.0);
  }
  return vec2(at_a <= at_b ? bend : -bend, (a_is_nearer ? 1.0 : -1.0) * min(gap, largest_gap));
}
