#version 450 core
// SPDX-License-Identifier: MIT
// Blinn-Phong light (3.1), summed over all lights, through ramps (3.2); deferred: it reads the G-buffer.
#include "generated/light.glsl"
#include "generated/material.glsl"

uniform sampler2D normal_and_depth_map;  // 0.5 N + 0.5; alpha: linear depth / far
uniform sampler2D object_id_map;         // 0 where no model is
uniform sampler2D ramp_table;            // row 0: diffuse, row 1: specular

layout(std140) uniform view_block {
  vec3 eye;         // world space; in orthographic views at the image's lower left corner
  float far;        // world units
  vec3 eye_right;   // added from the left side to the right one: zero in perspective views
  vec3 eye_up;      // added from the bottom to the top
  vec3 ray_corner;  // from the eye through the image's lower left corner, one unit along the view axis
  vec3 ray_right;   // added from the left side to the right one
  vec3 ray_up;      // added from the bottom to the top
  vec3 ambient;     // global ambient light
  vec3 background;
  int use_ramps;
  int light_count;
  int first_material;  // of those in material_list; pixels of the others are drawn by another go
  vec2 corner_px;      // of the part that is drawn, in the whole image
  vec2 whole_size_px;
} view;

layout(std140) uniform light_list { Light lights[max_lights]; };
layout(std140) uniform material_list { Material materials[materials_at_once]; };

layout(location = 0) out vec4 colour;

vec3 ramp(float t, int row) {
  if (view.use_ramps == 0) return vec3(t);
  int width = textureSize(ramp_table, 0).x;
  return texelFetch(ramp_table, ivec2(clamp(int(t * width), 0, width - 1), row), 0).rgb;
}

vec3 light_direction(Light light, vec3 position) {
  return normalize(light.type == light_type_point ? light.position - position : light.direction);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  float object_id = texelFetch(object_id_map, at, 0).r;
  int place_in_list = int(object_id + 0.5) - 1 - view.first_material;
  bool is_background = object_id < 0.5;
  if (is_background ? view.first_material > 0 : place_in_list < 0 || place_in_list >= materials_at_once) discard;
  if (is_background) {
    colour = vec4(view.background, 1.0);
    return;
  }
  Material material = materials[place_in_list];
  vec4 normal_and_depth = texelFetch(normal_and_depth_map, at, 0);
  vec2 place = (gl_FragCoord.xy + view.corner_px) / view.whole_size_px;
  vec3 ray = view.ray_corner + place.x * view.ray_right + place.y * view.ray_up;
  vec3 eye = view.eye + place.x * view.eye_right + place.y * view.eye_up;
  vec3 position = eye + ray * (normal_and_depth.a * view.far);
  vec3 to_eye = -normalize(ray);
  vec3 normal = normalize(2.0 * normal_and_depth.xyz - 1.0);

  vec3 ambient_coefficient = material.ambient * material.colour;
  vec3 diffuse_coefficient = material.diffuse * material.colour;
  vec3 sum = view.ambient * ambient_coefficient;
  for (int i = 0; i < view.light_count; ++i) {
    Light light = lights[i];
    vec3 to_light = light_direction(light, position);
    vec3 halfway = normalize(to_light + to_eye);
    float diffuse = max(dot(to_light, normal), 0.0);
    float specular = pow(max(dot(halfway, normal), 0.0), material.exponent);
    sum += light.ambient * ambient_coefficient;
    sum += ramp(diffuse, 0) * light.diffuse * diffuse_coefficient;
    sum += ramp(specular, 1) * light.specular * material.specular;
  }
  colour = vec4(sum, 1.0);
}
