#version 450 core
// SPDX-License-Identifier: MIT
// What each detected pixel is of: the class that its detector told, or what the surfaces around it tell.
#include "lib/lens.glsl"
#include "lib/edge_class.glsl"

uniform sampler2D detection_map;  // strength, class
uniform sampler2D normal_and_depth_map;
uniform sampler2D object_id_map;
layout(location = 0) out float line_class;

// A bend of so many pixel sizes, some ten degrees, can be seen as a crease.
const float least_bend = 0.2;

ivec2 inside(ivec2 at) { return clamp(at, ivec2(0), textureSize(object_id_map, 0) - 1); }

// Other ids, steps and bends are looked for along eight directions, up to `reach` pixels far.
float class_among_surfaces(ivec2 at, int reach) {
  float id = texelFetch(object_id_map, at, 0).r;
  bool other_id = false;
  for (int i = 0; i < 9 * reach && !other_id; ++i)
    other_id = texelFetch(object_id_map, inside(at + (i / 9 + 1) * (ivec2(i % 3, i / 3 % 3) - 1)), 0).r != id;
  bool other_ground = false;
  float step_px = 0.0, bend_px = 0.0;
  int turns = reach > 0 && !other_id ? 9 : 0;
  for (int i = 0; i < turns; ++i) {
    ivec2 towards = ivec2(i % 3, i / 3) - 1;
    if (i == 4) continue;
#define DEPTH_AT(steps) texelFetch(normal_and_depth_map, inside(at + (steps) * towards), 0).a
    float before = DEPTH_AT(-1), here = DEPTH_AT(0), next = DEPTH_AT(1);
    for (int k = 1; k <= reach; ++k) {
      float after = DEPTH_AT(k + 1);
      other_ground = other_ground || is_background(next) != is_background(here);
      // Where no model is there is neither; at the image's border a repeated pixel is no neighbour.
      ivec2 first = at + (k - 2) * towards, last = at + (k + 1) * towards;
      if (first == inside(first) && !is_background(here)) {
        float a = affine_depth(before), b = affine_depth(here), c = affine_depth(next), d = affine_depth(after);
        if (last == inside(last) && !is_background(next)) step_px = max(step_px, step_between(a, b, c, d));
        bend_px = max(bend_px, in_pixel_sizes(a - 2.0 * b + c, b));
      }
      before = here;
      here = next;
      next = after;
    }
  }
  if (other_id) return class_object;
  if (step_px > 1.0 || other_ground) return class_silhouette;
  return bend_px > least_bend ? class_crease : class_normal;
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  float told = texelFetch(detection_map, at, 0).g;
  // A compiler that makes -float(is_detected) of what the detector chooses between writes -0 for none.
  line_class = told < class_none ? class_among_surfaces(at, int(-told)) : abs(told);
}
