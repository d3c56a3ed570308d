// SPDX-License-Identifier: MIT
// How the camera's pixels lie in the world, and what the depth map says in its terms.

layout(std140) uniform lens_block {
  float far;         // world units
  float pixel_size;  // of a pixel: world units at distance 1; orthographic: world units anywhere
  int is_orthographic;
  int padding;
} lens;

// The depth map holds 1 where no model is.
bool is_background(float depth) { return depth >= 1.0; }

// What is affine in the image on a plane: 1 / distance (0 where no model is); orthographic: the distance.
float affine_depth(float depth) {
  if (lens.is_orthographic != 0) return depth * lens.far;
  return is_background(depth) ? 0.0 : 1.0 / (depth * lens.far);
}

// Of a second difference of `affine_depth` at a pixel that has `here`: how far a neighbour lies from the plane of the
// others along the view, in pixels' sizes in the world.
float in_pixel_sizes(float second_difference, float here) {
  float unit = lens.is_orthographic != 0 ? lens.pixel_size : here * lens.pixel_size;
  return abs(second_difference) / unit;
}
