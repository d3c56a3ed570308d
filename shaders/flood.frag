#version 450 core
// SPDX-License-Identifier: MIT
// One step of jump flooding: of the seeds that nine pixels know, the one whose line ends nearest.

uniform sampler2D seed_map;
layout(std140) uniform flood_block {
  int step_px;
} flood;
layout(location = 0) out vec4 seed;

// The squared distance less the squared half width: of two lines the one whose edge is nearer, or just about.
float power_of(vec4 seed) {
  vec2 away = seed.xy - gl_FragCoord.xy;
  return seed.a > 0.5 ? dot(away, away) - seed.z * seed.z : 1e30;
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  ivec2 size = textureSize(seed_map, 0);
  vec4 own = texelFetch(seed_map, at, 0);
  bool is_seed = own.a > 0.5 && ivec2(floor(own.xy)) == at;
  seed = own;
  float nearest = power_of(own);
  int taps = is_seed ? 0 : 9;  // a line's own pixels keep their point
  for (int i = 0; i < taps; ++i) {
    ivec2 there = clamp(at + flood.step_px * (ivec2(i % 3, i / 3) - 1), ivec2(0), size - 1);
    vec4 other = texelFetch(seed_map, there, 0);
    float power = power_of(other);
    if (power < nearest) {
      nearest = power;
      seed = other;
    }
  }
}
