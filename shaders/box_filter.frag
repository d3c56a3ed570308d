#version 450 core
// SPDX-License-Identifier: MIT
// A picture out of a buffer that was drawn several times as wide and as high, or of a part of that: the mean of what each
// of a pixel's samples would be shown as.

uniform sampler2D buffer_map;
layout(std140) uniform filter_block {
  ivec2 corner_px;  // of the buffer in the whole large image
  int times;        // samples a side of a pixel
  int channel;      // 0 to 3: that channel as grey; -1: the first three as colour
  float gain;
  float low;  // shown as black
} box;
layout(location = 0) out vec4 colour;

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * box.times - box.corner_px;
  vec3 sum = vec3(0.0);
  for (int y = 0; y < box.times; ++y) {
    for (int x = 0; x < box.times; ++x) {
      vec4 value = texelFetch(buffer_map, first + ivec2(x, y), 0);
      vec3 shown = box.channel >= 0 ? vec3(value[max(box.channel, 0)]) : value.rgb;
      sum += clamp((shown - box.low) * box.gain, 0.0, 1.0);
    }
  }
  colour = vec4(sum / float(box.times * box.times), 1.0);
}
