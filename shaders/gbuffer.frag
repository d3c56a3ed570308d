#version 450 core
// G-buffer: all geometry that later passes read, in one pass (the paper's future work 5.1).
#include "lib/draw_block.glsl"

in vec3 normal_world;
layout(location = 0) out vec4 normal_and_id;  // 0.5 N + 0.5 (3.4.1); alpha: object id
layout(location = 1) out float depth;         // linear depth / far, 0 to 1 (3.4.2)

void main() {
  normal_and_id = vec4(0.5 * normalize(normal_world) + 0.5, draw.object_id);
  // gl_FragCoord.w is 1 / (distance along the view axis): the paper's linearisation of gl_FragCoord.z gives the same
  // number after losing most of its digits near 1.
  depth = 1.0 / (gl_FragCoord.w * draw.far);
}
