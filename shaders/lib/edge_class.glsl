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

// `strength` under `weak` has no class. Steps and bends are looked for along eight directions, between the pixel and
// its neighbour and between that one and the next: operators reach so far.
float edge_class(ivec2 at, float strength, float weak) {
  if (!(strength >= weak)) return class_none;
  float id = texelFetch(object_id_map, at, 0).r;
  float own = texelFetch(normal_and_depth_map, at, 0).a;
  float here = affine_depth(own);
  bool other_id = false, other_ground = false;
  float step_px = 0.0, bend_px = 0.0;
  for (int i = 0; i < 9; ++i) {
    ivec2 towards = ivec2(i % 3, i / 3) - 1;
    if (i == 4) continue;
    float depth[4];
    for (int k = 0; k < 4; ++k) depth[k] = texelFetch(normal_and_depth_map, inside(at + (k - 1) * towards), 0).a;
    other_id = other_id || texelFetch(object_id_map, inside(at + towards), 0).r != id;
    other_ground = other_ground || is_background(depth[2]) != is_background(own);
    float a = affine_depth(depth[0]), c = affine_depth(depth[2]), d = affine_depth(depth[3]);
    step_px = max(step_px, step_between(a, here, c, d));
    bend_px = max(bend_px, in_pixel_sizes(a - 2.0 * here + c, here));
  }
  if (other_id) return class_object;
  if (step_px > 1.0 || other_ground) return class_silhouette;
  return bend_px > least_bend ? class_crease : class_normal;
}
