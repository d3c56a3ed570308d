#version 450 core
// SPDX-License-Identifier: MIT
// The second difference of what is affine on planes, along four directions, in units of slope: 0 on planes at any slope.
#include "generated/edges.glsl"
#include "generated/laplacian.glsl"

uniform sampler2D normal_and_depth_map;
layout(location = 0) out vec2 edge;  // strength, class

#include "lib/lens.glsl"
#include "lib/edge_class.glsl"

// Of a step from or to where no model is, in an orthographic view: it has no distance.
const float endless = 1000.0;

float slope_change(ivec2 at, ivec2 towards, float here) {
  ivec2 size = textureSize(normal_and_depth_map, 0);
  ivec2 before = at - towards, after = at + towards;
  if (any(lessThan(min(before, after), ivec2(0))) || any(greaterThanEqual(max(before, after), size))) return 0.0;
  float a = texelFetch(normal_and_depth_map, before, 0).a, b = texelFetch(normal_and_depth_map, after, 0).a;
  if (lens.is_orthographic != 0 && (is_background(a) || is_background(b))) return endless;
  return in_pixel_sizes(affine_depth(a) + affine_depth(b) - 2.0 * here, here);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  float own = texelFetch(normal_and_depth_map, at, 0).a;
  float here = affine_depth(own);
  float largest = max(max(slope_change(at, ivec2(1, 0), here), slope_change(at, ivec2(0, 1), here)),
                      max(slope_change(at, ivec2(1, 1), here), slope_change(at, ivec2(1, -1), here)));
  float strength = is_background(own) ? 0.0 : largest / laplacian.bend;
  edge = vec2(strength, strength >= edges.weak ? class_of_surfaces(1) : class_none);
}
