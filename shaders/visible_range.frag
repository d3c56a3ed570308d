#version 450 core
// SPDX-License-Identifier: MIT
// Nearest and farthest of 16 x 16 texels: of the depth map, then of what an earlier go gave.

uniform sampler2D value_map;  // alpha: linear depth / far; in later goes red and green: nearest and farthest
layout(std140) uniform range_block {
  float far;
  int is_first;
} range;
layout(location = 0) out vec2 visible;  // world units

void main() {
  ivec2 low = ivec2(gl_FragCoord.xy) * 16;
  ivec2 high = min(low + 16, textureSize(value_map, 0));
  visible = vec2(1e30, 0.0);
  for (int y = low.y; y < high.y; ++y) {
    for (int x = low.x; x < high.x; ++x) {
      vec4 value = texelFetch(value_map, ivec2(x, y), 0);
      bool is_surface = value.a < 1.0;
      if (range.is_first != 0) value.rg = is_surface ? vec2(value.a * range.far) : vec2(1e30, 0.0);
      visible = vec2(min(visible.x, value.r), max(visible.y, value.g));
    }
  }
}
