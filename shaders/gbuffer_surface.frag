#version 450 core
// SPDX-License-Identifier: MIT
// The G-buffer with the triangles' planes, for detectors that read them.
#include "lib/gbuffer_maps.glsl"
#include "lib/lens.glsl"
#include "lib/surface.glsl"

layout(std140) uniform surface_block {
  mat4 normal_to_view;  // upper 3 x 3: from the mesh's space
  vec2 middle_px;       // of the image
} surface_draw;
uniform samplerBuffer face_normals;     // of the mesh's triangles, in its own space
layout(location = 2) out vec4 surface;  // lib/surface.glsl

void main() {
  write_maps();
  vec3 normal = normalize(mat3(surface_draw.normal_to_view) * texelFetch(face_normals, gl_PrimitiveID).xyz);
  surface = surface_of(normal, ray_through(gl_FragCoord.xy - surface_draw.middle_px), normal_and_depth.a * draw.far, draw.object_id);
}
