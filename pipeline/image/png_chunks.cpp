#include "pipeline/image/png_chunks.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>

namespace inkbench {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
constexpr size_t kChunkFrameBytes = 12;  // length, type and check sum

constexpr std::array<uint32_t, 256> make_crc_table() {
  std::array<uint32_t, 256> table{};
  for (uint32_t i = 0; i < 256; ++i) {
    uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) value = (value & 1) != 0 ? 0xedb88320U ^ (value >> 1) : value >> 1;
    table[i] = value;
  }
  return table;
}

uint32_t crc32(std::string_view bytes) {
  static constexpr std::array<uint32_t, 256> kTable = make_crc_table();
  uint32_t crc = 0xffffffffU;
  for (const char byte : bytes) crc = kTable[(crc ^ static_cast<uint8_t>(byte)) & 0xff] ^ (crc >> 8);
  return ~crc;
}

std::string big_endian(uint32_t value) {
  std::string bytes;
  for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>((value >> shift) & 0xff);
  return bytes;
}

uint32_t from_big_endian(std::string_view bytes) {
  uint32_t value = 0;
  for (const char byte : bytes.substr(0, 4)) value = value << 8 | static_cast<uint8_t>(byte);
  return value;
}

bool is_ascii(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<uint8_t>(c) < 0x80; });
}

}  // namespace

std::string png_text_chunk(std::string_view name, std::string_view text) {
  assert(!name.empty() && name.size() <= 79 && is_ascii(name));
  const bool plain = is_ascii(text);
  std::string body(plain ? "tEXt" : "iTXt");
  body += name;
  // iTXt: end of name, not compressed (two bytes), no language, no translated name.
  body.append(plain ? 1 : 5, '\0');
  body += text;
  return big_endian(static_cast<uint32_t>(body.size() - 4)) + body + big_endian(crc32(body));
}

bool is_png(std::string_view content) {
  return content.starts_with(kSignature);
}

bool png_is_whole(std::string_view content) {
  size_t at = kSignature.size();
  while (at + kChunkFrameBytes <= content.size()) {
    const size_t end = at + kChunkFrameBytes + from_big_endian(content.substr(at));
    if (content.substr(at + 4, 4) == "IEND") return end <= content.size();
    at = end;
  }
  return false;
}

bool png_sums_are_right(std::string_view content) {
  size_t at = kSignature.size();
  while (at + kChunkFrameBytes <= content.size()) {
    const size_t length = from_big_endian(content.substr(at));
    if (length > content.size() - at - kChunkFrameBytes) return true;
    const std::string_view body = content.substr(at + 4, length + 4);
    if (crc32(body) != from_big_endian(content.substr(at + 8 + length))) return false;
    at += kChunkFrameBytes + length;
  }
  return true;
}

}  // namespace inkbench
