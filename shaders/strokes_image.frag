#version 450 core
// SPDX-License-Identifier: MIT
// Strokes painted with a picture: along the stroke from left to right, across it from top to bottom.
#include "lib/capsule.glsl"
#include "lib/stroke_block.glsl"
#include "lib/touch.glsl"

uniform sampler2D brush_map;

float texel(ivec2 place) {
  ivec2 size = textureSize(brush_map, 0);
  int x = strokes.is_stretched != 0 ? clamp(place.x, 0, size.x - 1) : (place.x % size.x + size.x) % size.x;
  return texelFetch(brush_map, ivec2(x, clamp(place.y, 0, size.y - 1)), 0).r;
}

float paint_at(vec2 at) {
  vec2 place = at * vec2(textureSize(brush_map, 0)) - 0.5, low = floor(place), t = place - low;
  ivec2 first = ivec2(low);
  return mix(mix(texel(first), texel(first + ivec2(1, 0)), t.x), mix(texel(first + ivec2(0, 1)), texel(first + ivec2(1, 1)), t.x), t.y);
}

float painted(Touch touch) {
  // The texture's first row is the picture's last one.
  float paint = paint_at(vec2(repetition_at(touch), 0.5 - 0.5 * touch.across));
  return solid_share(touch.foot) * (1.0 - strokes.grain * (1.0 - paint));
}

#include "lib/stroke_segment.glsl"
