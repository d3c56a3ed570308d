// SPDX-License-Identifier: MIT
// What the G-buffer holds of every pixel, whatever else it is drawn for.
#include "lib/draw_block.glsl"

in vec3 normal_world;
in float distance_in_view;
layout(location = 0) out vec4 normal_and_depth;  // 0.5 N + 0.5 (3.4.1); alpha: linear depth / far, 0 to 1 (3.4.2)
layout(location = 1) out float object_id;

void write_maps() {
  // gl_FragCoord.w is 1 / (distance along the view axis): the paper's linearisation of gl_FragCoord.z gives the same
  // number after losing most of its digits near 1. In orthographic views gl_FragCoord.w is 1.
  float depth = draw.orthographic == 1.0 ? distance_in_view / draw.far : 1.0 / (gl_FragCoord.w * draw.far);
  float side = gl_FrontFacing || draw.two_sided == 0.0 ? 1.0 : -1.0;
  normal_and_depth = vec4(0.5 * side * normalize(normal_world) + 0.5, depth);
  object_id = draw.object_id;
}
