// SPDX-License-Identifier: MIT
// How the camera's pixels lie in the world, and what the depth map says in its terms.

layout(std140) uniform lens_block {
  float far;         // world units
  float pixel_size;  // of a pixel: world units at distance 1; orthographic: world units anywhere
  int is_orthographic;
  int padding;
} lens;

// Eight bits round what is close to the camera to 0.
const float least_depth = 1e-12;

#include "lib/background.glsl"

// What is affine in the image on a plane: 1 / distance (0 where no model is); orthographic: the distance.
float affine_depth(float depth) {
  if (lens.is_orthographic != 0) return depth * lens.far;
  return is_background(depth) ? 0.0 : 1.0 / (max(depth, least_depth) * lens.far);
}

// Of a second difference of `affine_depth` at a pixel that has `here`: how far a neighbour lies from the plane of the
// others along the view, in pixels' sizes in the world.
float in_pixel_sizes(float second_difference, float here) {
  float unit = lens.is_orthographic != 0 ? lens.pixel_size : here * lens.pixel_size;
  return abs(second_difference) / unit;
}

// Between `b` and `c` of four values of `affine_depth` in a row: how far each lies from the plane through the two of the
// other side, the smaller distance of both, in pixels' sizes in the world. A bend, however sharp, has less than one.
float step_between(float a, float b, float c, float d) {
  float slope_b = in_pixel_sizes(b - a, b), slope_c = in_pixel_sizes(d - c, c);
  float c_from_b = in_pixel_sizes(a - 2.0 * b + c, b) * inversesqrt(1.0 + slope_b * slope_b);
  float b_from_c = in_pixel_sizes(b - 2.0 * c + d, c) * inversesqrt(1.0 + slope_c * slope_c);
  return min(c_from_b, b_from_c);
}
