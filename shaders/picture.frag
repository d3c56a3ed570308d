#version 450 core
// SPDX-License-Identifier: MIT
// A buffer as an 8-bit picture: one channel as grey, three as colour, object ids as distinct colours; what is above a
// value, times a gain.

uniform sampler2D buffer_map;
layout(std140) uniform picture_block {
  float gain;
  int channel;  // 0 to 3: that channel as grey; -1: the first three as colour; -2: red as an id's colour;
                // -3: offsets; -4: red as a line class's; -5: alpha as an id's colour
  float low;    // shown as black
} picture;
layout(location = 0) out vec4 colour;

// Hues a golden ratio apart stay distinct for any number of ids.
vec3 id_colour(float id) {
  if (id < 0.5) return vec3(0.0);
  vec3 hue = fract(id * 0.61803399 + vec3(0.0, 0.3333, 0.6667));
  return 0.35 + 0.65 * clamp(abs(hue * 6.0 - 3.0) - 1.0, 0.0, 1.0);
}

// Okabe and Ito's palette, which people with the common kinds of colour blindness can tell apart.
const vec3 class_colours[7] =
    vec3[](vec3(1.0), vec3(0.0), vec3(0.0, 0.447, 0.698), vec3(0.835, 0.369, 0.0), vec3(0.0, 0.62, 0.451),
           vec3(0.8, 0.475, 0.655), vec3(0.902, 0.624, 0.0));

void main() {
  vec4 value = texelFetch(buffer_map, ivec2(gl_FragCoord.xy), 0);
  vec3 shown = picture.channel >= 0 ? vec3(value[max(picture.channel, 0)]) : value.rgb;
  if (picture.channel == -2 || picture.channel == -5) shown = id_colour(picture.channel == -2 ? value.r : value.a);
  if (picture.channel == -3) shown = vec3(value.rg, 0.0) + 0.5 / picture.gain;
  if (picture.channel == -4) shown = class_colours[clamp(int(value.r + 0.5), 0, 6)];
  colour = vec4((shown - picture.low) * picture.gain, 1.0);
}
