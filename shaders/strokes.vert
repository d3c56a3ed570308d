#version 450 core
// SPDX-License-Identifier: MIT
// A quad around each segment of a stroke. Where the stroke goes on, it ends at the segment's own end, but for what only
// this segment is nearest to.

#include "lib/stroke_block.glsl"
layout(location = 0) in vec4 before_2;
layout(location = 1) in vec4 before_1;
layout(location = 2) in vec4 from_point;
layout(location = 3) in vec4 to_point;
layout(location = 4) in vec4 after_1;
layout(location = 5) in vec4 after_2;
layout(location = 6) in vec4 paint_in;
layout(location = 0) flat out vec4 points[6];
layout(location = 6) flat out vec4 paint;

// How far the quad reaches beyond the point.
float reach(vec4 point, vec4 beyond, vec2 direction, float slope) {
  vec2 way = beyond.xy - point.xy;
  float size = length(way);
  if (beyond.z < 0.0 || size < 1e-3) return point.z + 1.0;
  float turned = dot(way, direction) > 0.0 ? abs(way.x * direction.y - way.y * direction.x) / size : 1.0;
  return point.z * min(turned + slope, 1.0) + 1.0;
}

void main() {
  points = vec4[6](before_2, before_1, from_point, to_point, after_1, after_2);
  paint = paint_in;
  vec2 way = to_point.xy - from_point.xy;
  float size = length(way);
  vec2 direction = size > 0.0 ? way / size : vec2(1.0, 0.0);
  float slope = size > 0.0 ? abs(to_point.z - from_point.z) / size : 1.0;
  bool is_end = (gl_VertexID & 1) != 0, is_right = (gl_VertexID & 2) != 0;
  float along = is_end ? size + reach(to_point, after_1, direction, slope) : -reach(from_point, before_1, -direction, slope);
  float aside = (max(from_point.z, to_point.z) + 1.0) * (is_right ? 1.0 : -1.0);
  vec2 corner = from_point.xy + along * direction + aside * vec2(-direction.y, direction.x);
  gl_Position = is_segment(paint_in) ? vec4(to_clip(corner), 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
