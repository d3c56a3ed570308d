// SPDX-License-Identifier: MIT
// What one model's draw needs.

layout(std140) uniform draw_block {
  mat4 model_to_clip;
  mat4 normal_to_world;  // upper 3 x 3: inverse transpose of the model matrix
  float object_id;       // 1, 2, ... in the scene's order of models
  float far;             // world units
  float two_sided;       // 1: a face seen from behind takes the opposite normal; 0: its own
  float orthographic;    // 1: an orthographic view; 0: a perspective one
  vec4 model_to_distance;  // dot product with a point of the model: its distance along the view axis
} draw;
