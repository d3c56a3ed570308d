#version 450 core
// SPDX-License-Identifier: MIT
// Where each pixel's surface point stands in another frame: out of the depth, by the cameras' projections and the models'
// places in both. No word of how a camera projects: the matrices say it, perspective or not.

const int models_at_once = 128;  // motion.cpp has the same

uniform sampler2D normal_and_depth_map;
uniform sampler2D object_id_map;
layout(std140) uniform motion_block {
  mat4 projection;
  mat4 other_projection;
  vec2 size_px;
  vec2 other_size_px;
  float far;
  int first_model;  // of this go
} motion;
layout(std140) uniform motion_models {
  mat4 to_other_eye[models_at_once];  // eye space to the other frame's, by model; all 0 where it is not there
} models;
layout(location = 0) out vec4 result;  // px to the right, px down, distance along the view axis there; 1 where it is

// The point in eye space that the projection takes to this place of the image at this height.
vec3 eye_point(vec2 place, float z) {
  float w = motion.projection[2][3] * z + motion.projection[3][3];
  vec2 moved = vec2(motion.projection[2][0], motion.projection[2][1]) * z + motion.projection[3].xy;
  return vec3((place * w - moved) / vec2(motion.projection[0][0], motion.projection[1][1]), z);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  int model = int(texelFetch(object_id_map, at, 0).r) - 1 - motion.first_model;
  bool is_mine = model >= 0 && model < models_at_once;
  if (!is_mine && motion.first_model > 0) discard;
  float z = -texelFetch(normal_and_depth_map, at, 0).a * motion.far;
  vec3 here = eye_point(2.0 * gl_FragCoord.xy / motion.size_px - 1.0, z);
  mat4 move = models.to_other_eye[clamp(model, 0, models_at_once - 1)];
  vec4 there = move * vec4(here, 1.0);
  vec4 clip = motion.other_projection * there;
  bool is_there = is_mine && there.w > 0.5 && clip.w > 0.0 && abs(clip.z) <= clip.w;
  vec2 there_px = (0.5 + vec2(0.5, -0.5) * clip.xy / clip.w) * motion.other_size_px;  // y down from the top, as in images
  vec2 here_px = vec2(gl_FragCoord.x, motion.size_px.y - gl_FragCoord.y);
  result = is_there ? vec4(there_px - here_px, -there.z, 1.0) : vec4(0.0);
}
