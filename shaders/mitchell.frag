#version 450 core
// SPDX-License-Identifier: MIT
// Mitchell, Brennan and Card's discontinuities between a pixel and its four neighbours: normals, depth, object ids and
// materials' colours, each against its limit.
#include "generated/edges.glsl"
#include "generated/mitchell.glsl"

uniform sampler2D normal_and_depth_map;
uniform sampler2D object_id_map;
uniform sampler2D albedo_map;  // alpha: 0 where no model is
layout(location = 0) out vec2 edge;  // strength, class

#include "lib/background.glsl"
#include "lib/edge_class.glsl"

const ivec2 neighbours[4] = ivec2[](ivec2(-1, 0), ivec2(1, 0), ivec2(0, -1), ivec2(0, 1));

vec3 unit_normal(vec4 normal_and_depth) { return normalize(2.0 * normal_and_depth.rgb - 1.0); }

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 here = texelFetch(normal_and_depth_map, at, 0);
  float id = texelFetch(object_id_map, at, 0).r;
  vec4 albedo = texelFetch(albedo_map, at, 0);
  vec3 normal = unit_normal(here);
  float tangent2 = 0.0, depth = 0.0, colour = 0.0;  // of half the angle, squared
  bool other_id = false;
  for (int i = 0; i < 4; ++i) {
    ivec2 place = clamp(at + neighbours[i], ivec2(0), textureSize(object_id_map, 0) - 1);
    vec4 there = texelFetch(normal_and_depth_map, place, 0);
    depth = max(depth, abs(there.a - here.a));
    other_id = other_id || texelFetch(object_id_map, place, 0).r != id;
    // What is no surface has neither a normal nor a material.
    if (is_background(here.a) || is_background(there.a)) continue;
    vec3 other = unit_normal(there);
    vec3 difference = normal - other, sum = normal + other;
    tangent2 = max(tangent2, dot(difference, difference) / max(dot(sum, sum), 1e-12));
    vec3 apart = abs(texelFetch(albedo_map, place, 0).rgb - albedo.rgb);
    colour = max(colour, max(apart.r, max(apart.g, apart.b)));
  }
  float angle = degrees(2.0 * atan(sqrt(tangent2)));
  float of_shape = max(max(angle / mitchell.angle, depth / mitchell.depth), other_id ? float(mitchell.use_ids) : 0.0);
  float of_colour = colour / mitchell.albedo;
  float strength = max(of_shape, of_colour);
  bool is_shape = of_shape >= edges.weak, is_colour = of_colour >= edges.weak;
  edge = vec2(strength, is_shape ? class_of_surfaces(1) : is_colour ? class_material : class_none);
}
