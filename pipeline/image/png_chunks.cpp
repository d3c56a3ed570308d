// SPDX-License-Identifier: MIT
#include "pipeline/image/png_chunks.h"

#include <libdeflate.h>

#include <algorithm>
#include <cassert>
#include <cstdint>

namespace inkbench {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
constexpr size_t kChunkFrameBytes = 12;  // length, type and check sum

uint32_t crc32(std::string_view bytes) {
  return libdeflate_crc32(0, bytes.data(), bytes.size());
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

/// `body` begins with the chunk's type.
std::string framed(const std::string& body) {
  return big_endian(static_cast<uint32_t>(body.size() - 4)) + body + big_endian(crc32(body));
}

}  // namespace

std::string png_open(int width_px, int height_px, int channels) {
  assert(channels == 1 || channels == 3 || channels == 4);
  constexpr char kGrey = 0, kColour = 2, kColourAndAlpha = 6, kBits = 8;
  const char type = channels == 1 ? kGrey : channels == 3 ? kColour : kColourAndAlpha;
  const std::string body = big_endian(static_cast<uint32_t>(width_px)) +
                           big_endian(static_cast<uint32_t>(height_px)) + kBits + type + std::string(3, '\0');
  return std::string(kSignature) + make_png_chunk("IHDR", body);
}

std::string make_png_chunk(std::string_view type, std::string_view body) {
  assert(type.size() == 4);
  return framed(std::string(type).append(body));
}

std::string png_srgb_chunks() {
  std::string primaries;  // white, red, green, blue: x and y in 100,000ths
  for (const uint32_t value : {31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000})
    primaries += big_endian(value);
  return make_png_chunk("gAMA", big_endian(45455)) + make_png_chunk("sRGB", std::string_view("\0", 1)) +
         make_png_chunk("cHRM", primaries);
}

std::string png_text_chunk(std::string_view name, std::string_view text) {
  assert(!name.empty() && name.size() <= 79 && is_ascii(name));
  const bool plain = is_ascii(text);
  std::string body(plain ? "tEXt" : "iTXt");
  body += name;
  // iTXt: end of name, not compressed (two bytes), no language, no translated name.
  body.append(plain ? 1 : 5, '\0');
  body += text;
  return framed(body);
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
