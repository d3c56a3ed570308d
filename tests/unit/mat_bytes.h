// SPDX-License-Identifier: MIT
// MATLAB files (version 5) to test with, written as the format's description has them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace inkbench {

inline std::string mat_number(uint32_t value) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
  return bytes;
}

inline std::string mat_element(uint32_t type, const std::string& data) {
  const std::string padding((8 - data.size() % 8) % 8, '\0');
  return mat_number(type) + mat_number(static_cast<uint32_t>(data.size())) + data + padding;
}

/// Flags, sides and name, as every matrix begins.
inline std::string mat_head(uint8_t matrix_class, const std::vector<uint32_t>& sides,
                            const std::string& name) {
  std::string dimensions;
  for (const uint32_t side : sides) dimensions += mat_number(side);
  return mat_element(6, mat_number(matrix_class) + mat_number(0)) + mat_element(5, dimensions) +
         mat_element(1, name);
}

inline std::string mat_matrix(const std::string& content) {
  return mat_element(14, content);
}

/// Bytes, one row a text, '#' for 1; stored column by column.
inline std::string mat_bytes(const std::vector<std::string_view>& rows) {
  std::string data;
  for (size_t x = 0; x < rows.front().size(); ++x) {
    for (const std::string_view row : rows) data += row[x] == '#' ? '\1' : '\0';
  }
  const std::vector<uint32_t> sides{static_cast<uint32_t>(rows.size()),
                                    static_cast<uint32_t>(rows.front().size())};
  return mat_matrix(mat_head(9, sides, "") + mat_element(2, data));
}

/// As BSDS500 has it: Segmentation, which is left out of account, and Boundaries.
inline std::string mat_annotator(const std::vector<std::string_view>& rows) {
  constexpr size_t kNameBytes = 16;
  std::string names;
  for (std::string name : {"Segmentation", "Boundaries"}) {
    name.resize(kNameBytes, '\0');
    names += name;
  }
  // The length of names comes as a small element: type and size in four bytes.
  const std::string length = mat_number(5 | 4 << 16) + mat_number(kNameBytes);
  return mat_matrix(mat_head(2, {1, 1}, "") + length + mat_element(1, names) + mat_bytes({"##", "##"}) +
                    mat_bytes(rows));
}

inline std::string mat_ground_truth(const std::vector<std::string>& annotators) {
  std::string content = mat_head(1, {1, static_cast<uint32_t>(annotators.size())}, "groundTruth");
  for (const std::string& annotator : annotators) content += annotator;
  return mat_matrix(content);
}

inline std::string mat_file(const std::string& elements) {
  std::string head = "MATLAB 5.0 MAT-file, written by a test";
  head.resize(124, ' ');
  return head + std::string("\0\1IM", 4) + elements;
}

/// The element inside zlib's frame, as one block that is stored as it is (under 64 kB).
inline std::string mat_compressed(const std::string& element) {
  uint32_t a = 1, b = 0;
  for (const char byte : element) {
    a = (a + static_cast<uint8_t>(byte)) % 65521;
    b = (b + a) % 65521;
  }
  const auto size = static_cast<uint32_t>(element.size());
  std::string packed = "\x78\x01\x01" + mat_number(size | (~size & 0xffff) << 16) + element;
  for (const uint32_t part : {b >> 8, b, a >> 8, a}) packed += static_cast<char>(part & 0xff);
  return mat_number(15) + mat_number(static_cast<uint32_t>(packed.size())) + packed;
}

}  // namespace inkbench
