// SPDX-License-Identifier: MIT
// What a G-buffer keeps of a normal in 16-bit floats, and of a depth in 16-bit floats or as a 24-bit window depth.

layout(std140) uniform stored_block {
  float near;  // world units
  float far;
  int is_orthographic;
  int format;  // image.precision
} stored;

const int format_unorm8 = 1, format_half = 2, format_depth24 = 3;

const double window_levels = 16777215.0LF;

float half_float(float value) { return unpackHalf2x16(packHalf2x16(vec2(value, 0.0))).x; }

vec3 half_float(vec3 value) { return vec3(half_float(value.x), half_float(value.y), half_float(value.z)); }

// Rounded to a level of the window's depth, whose levels lie evenly between the planes in orthographic views, and in
// others grow apart with the square of the distance. In doubles: a float has no more digits than the levels.
float window_rounded(float distance) {
  double z = double(distance), near = double(stored.near), far = double(stored.far), between = far - near;
  double window = stored.is_orthographic != 0 ? (z - near) / between : far * (z - near) / (z * between);
  double level = clamp(round(window * window_levels), 0.0LF, window_levels) / window_levels;
  return float(stored.is_orthographic != 0 ? near + level * between : far * near / (far - level * between));
}

// Of a depth as a share of the far plane's; 1, where no model is, stays 1.
float stored_depth(float depth) {
  if (depth >= 1.0) return 1.0;
  return stored.format == format_depth24 ? window_rounded(depth * stored.far) / stored.far : half_float(depth);
}
