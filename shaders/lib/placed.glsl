// SPDX-License-Identifier: MIT
// Placed lines in eight bits a channel (pipeline/passes/placing/placed_lines.h).

struct Placed {
  vec2 offset;       // from the pixel's centre to the line, in pixels, less than half each way
  float line_class;  // 0: no line goes through the pixel
  float share;       // of the width; what is under 1 before lines are connected is the strength
};

vec4 packed_line(Placed line) {
  float share = line.share >= 1.0 ? 1.0 : floor(254.0 * line.share) / 255.0;
  return line.line_class < 0.5 ? vec4(0.0) : vec4((line.offset * 254.0 + 127.0) / 255.0, line.line_class / 255.0, share);
}

// No line has class 0: all that can be said without unpacking.
bool is_placed(vec4 texel) { return texel.b > 0.0; }

Placed unpacked_line(vec4 texel) { return Placed((texel.rg * 255.0 - 127.0) / 254.0, floor(texel.b * 255.0 + 0.5), texel.a); }
