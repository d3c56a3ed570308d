// SPDX-License-Identifier: MIT
// PNG files of any bit depth and colour type, byte by byte: apart from the writer's code, which tests compare
// with them.
#pragma once

#include <cstdint>
#include <string>

namespace inkbench {

inline std::string big_endian(uint32_t v) {
  return {static_cast<char>(v >> 24), static_cast<char>(v >> 16), static_cast<char>(v >> 8),
          static_cast<char>(v)};
}

inline std::string png_chunk(const std::string& type, const std::string& body) {
  uint32_t crc = 0xffffffffU;
  for (const char byte : type + body) {
    crc ^= static_cast<uint8_t>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? 0xedb88320U ^ (crc >> 1) : crc >> 1;
  }
  return big_endian(static_cast<uint32_t>(body.size())) + type + body + big_endian(~crc);
}

/// `more` are chunks before the data; `rows` are at most 65,535 bytes, each row behind its filter's number.
/// They are stored, not packed.
inline std::string tiny_png(uint32_t width, uint32_t height, char bits, char colour_type,
                            const std::string& more, const std::string& rows) {
  uint32_t a = 1, b = 0;
  for (const char byte : rows) {
    a = (a + static_cast<uint8_t>(byte)) % 65521;
    b = (b + a) % 65521;
  }
  const auto size = static_cast<uint16_t>(rows.size());
  const std::string lengths{static_cast<char>(size), static_cast<char>(size >> 8), static_cast<char>(~size),
                            static_cast<char>(~size >> 8)};
  const std::string data = "\x78\x01\x01" + lengths + rows + big_endian(b << 16 | a);
  const std::string head = big_endian(width) + big_endian(height) + bits + colour_type + std::string(3, '\0');
  return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", head) + more + png_chunk("IDAT", data) +
         png_chunk("IEND", "");
}

}  // namespace inkbench
