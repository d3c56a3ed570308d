#version 450 core
// SPDX-License-Identifier: MIT
// A mesh's edges over a picture: one colour.

layout(std140) uniform wire_block {
  mat4 model_to_tile;
  vec4 colour;
} wire;
layout(location = 0) out vec4 colour;

void main() {
  colour = wire.colour;
}
