#version 450 core
// SPDX-License-Identifier: MIT
// A mesh's edges over a picture: model space to the clip space of the tile that shows the picture.

layout(std140) uniform wire_block {
  mat4 model_to_tile;
  vec4 colour;
} wire;
layout(location = 0) in vec3 position_model;

void main() {
  gl_Position = wire.model_to_tile * vec4(position_model, 1.0);
}
