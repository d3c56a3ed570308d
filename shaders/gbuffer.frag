#version 450 core
// SPDX-License-Identifier: MIT
// G-buffer: all geometry that later passes read, in one pass (the paper's future work 5.1).
#include "lib/draw_block.glsl"
#include "lib/lens.glsl"
#include "lib/surface.glsl"

in vec3 normal_world;
in float distance_in_view;
layout(std140) uniform surface_block {
  mat4 normal_to_view;  // upper 3 x 3: from the mesh's space
  vec2 middle_px;       // of the image
  int is_wanted;
} surface_draw;
uniform samplerBuffer face_normals;  // of the mesh's triangles, in its own space
layout(location = 0) out vec4 normal_and_depth;  // 0.5 N + 0.5 (3.4.1); alpha: linear depth / far, 0 to 1 (3.4.2)
layout(location = 1) out float object_id;
layout(location = 2) out vec4 surface;  // lib/surface.glsl

void main() {
  // gl_FragCoord.w is 1 / (distance along the view axis): the paper's linearisation of gl_FragCoord.z gives the same
  // number after losing most of its digits near 1. In orthographic views gl_FragCoord.w is 1.
  float depth = draw.orthographic == 1.0 ? distance_in_view / draw.far : 1.0 / (gl_FragCoord.w * draw.far);
  float side = gl_FrontFacing || draw.two_sided == 0.0 ? 1.0 : -1.0;
  normal_and_depth = vec4(0.5 * side * normalize(normal_world) + 0.5, depth);
  object_id = draw.object_id;
  surface = vec4(0.0);
  for (int turn = 0; turn < surface_draw.is_wanted; ++turn) {  // one turn or none
    vec3 normal = normalize(mat3(surface_draw.normal_to_view) * texelFetch(face_normals, gl_PrimitiveID).xyz);
    surface = surface_of(normal, ray_through(gl_FragCoord.xy - surface_draw.middle_px), depth * draw.far, draw.object_id);
  }
}
