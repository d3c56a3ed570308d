#version 450 core
// SPDX-License-Identifier: MIT
// Model to clip space; the normal goes to world space.
#include "lib/draw_block.glsl"

layout(location = 0) in vec3 position_model;
layout(location = 1) in vec3 normal_model;
out vec3 normal_world;
out float distance_in_view;  // along the view axis; of orthographic views alone

void main() {
  normal_world = mat3(draw.normal_to_world) * normal_model;
  distance_in_view = dot(draw.model_to_distance, vec4(position_model, 1.0));
  gl_Position = draw.model_to_clip * vec4(position_model, 1.0);
}
