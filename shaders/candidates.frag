#version 450 core
// SPDX-License-Identifier: MIT
// Detected pixels without those that lie behind a detected step: a line is the nearer surface's.
#include "generated/edges.glsl"
#include "lib/lens.glsl"

uniform sampler2D detection_map;  // strength
uniform sampler2D normal_and_depth_map;
layout(location = 0) out float candidate;  // 0 or 1

ivec2 clamped(ivec2 at) { return clamp(at, ivec2(0), textureSize(detection_map, 0) - 1); }
bool is_detected(ivec2 at) { return texelFetch(detection_map, clamped(at), 0).r >= edges.weak; }
float depth_at(ivec2 at) { return texelFetch(normal_and_depth_map, clamped(at), 0).a; }

// Is there a step up from `far_side` to the nearer `near_side`, which lies off the plane through it and `behind_it`, and
// the other way round?
bool is_step_up(float before_far, float far_side, float near_side, float behind_near) {
  if (is_background(near_side) || near_side >= far_side) return false;
  if (is_background(far_side)) return true;
  return step_between(affine_depth(before_far), affine_depth(far_side), affine_depth(near_side), affine_depth(behind_near)) > 1.0;
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  bool detected = is_detected(at);
  int directions = detected ? 9 : 0;  // a loop without turns costs nothing
  bool is_behind = false;
  for (int i = 0; i < directions; ++i) {
    ivec2 d = ivec2(i % 3, i / 3) - 1;
    if (i == 4) continue;
    float before = depth_at(at - d), here = depth_at(at), first = depth_at(at + d), second = depth_at(at + 2 * d),
          third = depth_at(at + 3 * d);
    // Operators look a pixel or two far.
    bool first_is_nearer = is_step_up(before, here, first, second) && is_detected(at + d);
    bool second_is_nearer = is_step_up(here, first, second, third) && is_detected(at + 2 * d);
    is_behind = is_behind || first_is_nearer || second_is_nearer;
  }
  candidate = detected && !is_behind ? 1.0 : 0.0;
}
