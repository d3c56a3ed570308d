// SPDX-License-Identifier: MIT
// Pairs of neighbours against the limits: which of a pixel's four sides are lines of its own.
#include "generated/dihedral.glsl"

#include "lib/pair_map.glsl"
#include "lib/edge_class.glsl"

uniform sampler2D pair_map;

struct Side {
  float strength;    // 1 = at the limit; 0 where the line would be the neighbour's
  float line_class;  // of what is seen, whatever its strength
  float meets;       // of a crease: pixels from the centre to where the planes meet
};

// `sign` is 1 where the pair is the pixel's own, to the right and above, and -1 for the neighbours' to the left and below.
Side side_of(float angle, float gap, float sign, float weak) {
  float apart = abs(gap);
  float step_strength = apart > meeting_gap ? apart / dihedral.gap : 0.0;
  bool is_step = step_strength >= weak;
  bool is_own = (is_step ? gap : angle) * sign > 0.0;
  float strength = is_own ? max(abs(angle) / dihedral.angle, step_strength) : 0.0;
  float bend_class = dihedral.normals == dihedral_normals_shading ? class_normal : class_crease;
  float line_class = apart > largest_gap ? class_object : is_step ? class_silhouette : bend_class;
  float share = min(apart / meeting_gap, 1.0);
  return Side(strength, line_class, sign > 0.0 ? share : 1.0 - share);
}

struct Sides {
  Side right, above, left, below;
};

Sides sides_of(ivec2 at, float weak) {
  vec4 own = texelFetch(pair_map, at, 0);
  vec4 left = texelFetch(pair_map, ivec2(max(at.x - 1, 0), at.y), 0);
  vec4 below = texelFetch(pair_map, ivec2(at.x, max(at.y - 1, 0)), 0);
  // The image's border has no neighbours beyond it.
  left *= at.x > 0 ? 1.0 : 0.0;
  below *= at.y > 0 ? 1.0 : 0.0;
  return Sides(side_of(own.x, own.z, 1.0, weak), side_of(own.y, own.w, 1.0, weak), side_of(left.x, left.z, -1.0, weak),
               side_of(below.y, below.w, -1.0, weak));
}

float strongest(Sides sides) {
  return max(max(sides.right.strength, sides.left.strength), max(sides.above.strength, sides.below.strength));
}

// Of the sides that reach `weak`, the first class in the order of the constants.
float class_of(Sides sides, float weak) {
  float line_class = 100.0;
  if (sides.right.strength >= weak) line_class = min(line_class, sides.right.line_class);
  if (sides.above.strength >= weak) line_class = min(line_class, sides.above.line_class);
  if (sides.left.strength >= weak) line_class = min(line_class, sides.left.line_class);
  if (sides.below.strength >= weak) line_class = min(line_class, sides.below.line_class);
  return line_class > class_normal ? class_none : line_class;
}
