#version 450 core
// SPDX-License-Identifier: MIT
// Saito and Takahashi's depth: affine in the image on planes, 0 at the nearest and 1 at the farthest visible distance,
// whatever the camera's planes.
#include "lib/lens.glsl"

uniform sampler2D normal_and_depth_map;
uniform sampler2D visible_range_map;  // nearest and farthest
layout(location = 0) out float depth;

// Of the farthest distance: what is visible lies at one distance but for rounding.
const float no_range = 1e-4;
// Where no model is, if 1 / distance = 0 does not say it.
const float beyond = 2.0;

void main() {
  vec2 visible = texelFetch(visible_range_map, ivec2(0), 0).rg;
  float own = texelFetch(normal_and_depth_map, ivec2(gl_FragCoord.xy), 0).a;
  bool has_range = visible.y - visible.x > no_range * visible.y;
  // Eight bits round depths out of the range.
  float distance = clamp(own * lens.far, visible.x, max(visible.y, visible.x));
  float perspective = (1.0 / distance - 1.0 / visible.x) / (1.0 / visible.y - 1.0 / visible.x);
  float behind = visible.y / (visible.y - visible.x);
  float orthographic = (distance - visible.x) / (visible.y - visible.x);
  bool is_orthographic = lens.is_orthographic != 0;
  if (is_background(own))
    depth = has_range && !is_orthographic ? behind : beyond;
  else
    depth = has_range ? (is_orthographic ? orthographic : perspective) : 0.0;
}
