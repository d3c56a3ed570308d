// SPDX-License-Identifier: MIT
#include "tests/cli/written_mesh.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>

namespace inkbench {
namespace {

constexpr std::array<std::array<int, 4>, 6> kCubeSides{
    {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};

/// Corner `i` of the unit cube: its bits are x, y and z.
std::array<int, 3> cube_corner(int i) {
  return {i & 1, (i >> 1) & 1, (i >> 2) & 1};
}

template <class Number>
void append_raw(std::string& bytes, Number number) {
  std::array<char, sizeof(Number)> raw;
  std::memcpy(raw.data(), &number, sizeof(Number));
  bytes.append(raw.data(), raw.size());
}

}  // namespace

std::string cube_off(double side, double corner) {
  std::ostringstream text;
  text << "OFF\n8 6 0\n";
  for (int i = 0; i < 8; ++i) {
    for (const int bit : cube_corner(i)) text << bit * side + corner << ' ';
    text << '\n';
  }
  for (const auto& s : kCubeSides) text << "4 " << s[0] << ' ' << s[1] << ' ' << s[2] << ' ' << s[3] << '\n';
  return text.str();
}

std::string cube_obj() {
  std::ostringstream text;
  for (int i = 0; i < 8; ++i) {
    const auto [x, y, z] = cube_corner(i);
    text << "v " << x << ' ' << y << ' ' << z << '\n';
  }
  for (const auto& s : kCubeSides)
    text << "f " << s[0] + 1 << ' ' << s[1] + 1 << ' ' << s[2] + 1 << ' ' << s[3] + 1 << '\n';
  return text.str();
}

std::string cube_ply() {
  std::ostringstream text;
  text << "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
          "element face 6\nproperty list uchar int vertex_indices\nend_header\n";
  for (int i = 0; i < 8; ++i) {
    const auto [x, y, z] = cube_corner(i);
    text << x << ' ' << y << ' ' << z << '\n';
  }
  for (const auto& s : kCubeSides) text << "4 " << s[0] << ' ' << s[1] << ' ' << s[2] << ' ' << s[3] << '\n';
  return text.str();
}

std::string cube_stl() {
  std::string bytes(80, ' ');
  append_raw(bytes, uint32_t{12});
  for (const auto& side : kCubeSides) {
    for (const auto& triangle : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
      for (int i = 0; i < 3; ++i) append_raw(bytes, 0.0F);  // the normal, which readers compute
      for (const int place : triangle) {
        for (const int bit : cube_corner(side[place])) append_raw(bytes, static_cast<float>(bit));
      }
      append_raw(bytes, uint16_t{0});
    }
  }
  return bytes;
}

std::string wave_ply(int cells) {
  const int side = cells + 1;
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(side * side) +
                      "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                      std::to_string(2 * cells * cells) +
                      "\nproperty list uchar int vertex_indices\nend_header\n";
  bytes.reserve(bytes.size() + 12 * size_t(side) * side + 26 * size_t(cells) * cells);
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const float x = static_cast<float>(i) / cells, y = static_cast<float>(j) / cells;
      append_raw(bytes, x);
      append_raw(bytes, y);
      append_raw(bytes, 0.05F * std::sin(20.0F * x) * std::cos(20.0F * y));
    }
  }
  for (int32_t j = 0; j < cells; ++j) {
    for (int32_t i = 0; i < cells; ++i) {
      const int32_t a = j * side + i;
      for (const auto& triangle :
           {std::array{a, a + 1, a + side + 1}, std::array{a, a + side + 1, a + side}}) {
        append_raw(bytes, uint8_t{3});
        for (const int32_t index : triangle) append_raw(bytes, index);
      }
    }
  }
  return bytes;
}

std::string junk(size_t bytes) {
  std::string content;
  uint32_t state = 12345;
  for (size_t i = 0; i < bytes; ++i) {
    state = state * 1664525U + 1013904223U;
    content += static_cast<char>(state >> 24);
  }
  return content;
}

}  // namespace inkbench
