#version 450 core
// SPDX-License-Identifier: MIT
// The planes of the triangles as they follow from the normals and depths that a smaller G-buffer stores.
#include "lib/lens.glsl"
#include "lib/place.glsl"
#include "lib/stored.glsl"
#include "lib/surface.glsl"

uniform sampler2D surface_map;
layout(location = 0) out vec4 surface;

void main() {
  vec4 exact = texelFetch(surface_map, ivec2(gl_FragCoord.xy), 0);
  vec2 ray = ray_through(gl_FragCoord.xy - place.middle_px);
  vec3 normal = half_float(normalize(surface_normal(exact, ray)));
  surface = exact.w > 0.0 ? surface_of(normal, ray, stored_depth(exact.z / stored.far) * stored.far, exact.w) : exact;
}
