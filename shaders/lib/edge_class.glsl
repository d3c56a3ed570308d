// SPDX-License-Identifier: MIT
// What a detected pixel is of, by the surfaces around it (measures.md 6). Needs lib/lens.glsl and the samplers
// normal_and_depth_map and object_id_map.

const float class_none = 0.0;
const float class_object = 1.0;
const float class_silhouette = 2.0;
const float class_crease = 3.0;
const float class_normal = 4.0;
const float class_shadow = 5.0;
const float class_material = 6.0;

// A bend of so many pixel sizes, some ten degrees, can be seen as a crease.
const float least_bend = 0.2;

ivec2 inside(ivec2 at) { return clamp(at, ivec2(0), textureSize(object_id_map, 0) - 1); }

// `strength` under `weak` has no class. Other ids, steps and bends are looked for along eight directions, up to `reach`
// pixels far, as far as the detector's operator sees. Loops without turns cost nothing, and most pixels need none.
float edge_class(ivec2 at, float strength, float weak, int reach) {
  bool is_detected = strength >= weak;
  float id = texelFetch(object_id_map, at, 0).r;
  bool other_id = false;
  int id_turns = is_detected ? 9 * reach : 0;
  for (int i = 0; i < id_turns && !other_id; ++i)
    other_id = texelFetch(object_id_map, inside(at + (i / 9 + 1) * (ivec2(i % 3, i / 3 % 3) - 1)), 0).r != id;
  bool other_ground = false;
  float step_px = 0.0, bend_px = 0.0;
  int turns = is_detected && !other_id ? 9 : 0;
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
  if (!is_detected) return class_none;
  if (other_id) return class_object;
  if (step_px > 1.0 || other_ground) return class_silhouette;
  return bend_px > least_bend ? class_crease : class_normal;
}
