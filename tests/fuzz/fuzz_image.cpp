// SPDX-License-Identifier: MIT
// Bytes as image files read as line maps: nothing but an inkbench::Error may come out besides a map of the
// image's size. The first byte chooses: the bytes are the file; patches to a good PNG or EXR; or the head and
// the pixels of a PNG. Check sums of PNG chunks are put right, so that damage gets past them.
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/scratch_folder.h"
#include "pipeline/image/image_file.h"
#include "pipeline/line_file.h"

namespace inkbench {
namespace {

constexpr size_t kSignatureBytes = 8;

void require(bool condition) {
  if (!condition) std::abort();
}

/// One folder for the whole run, in memory where the system has such a place. An Error ends the run.
const fs::path& scratch_folder() noexcept {
  static const ScratchFolder scratch(memory_place());
  return scratch.path();
}

uint32_t crc32(std::string_view bytes) {
  uint32_t crc = 0xffffffffU;
  for (const char byte : bytes) {
    crc ^= static_cast<uint8_t>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? 0xedb88320U ^ (crc >> 1) : crc >> 1;
  }
  return ~crc;
}

uint32_t adler32(std::string_view bytes) {
  uint32_t low = 1, high = 0;
  for (const char byte : bytes) {
    low = (low + static_cast<uint8_t>(byte)) % 65521;
    high = (high + low) % 65521;
  }
  return high << 16 | low;
}

void put(std::string& bytes, size_t at, uint32_t value) {
  for (int i = 0; i < 4; ++i) bytes[at + i] = static_cast<char>(value >> (24 - 8 * i));
}

uint32_t get(const std::string& bytes, size_t at) {
  uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<uint8_t>(bytes[at + i]);
  return value;
}

/// The check sum of each whole chunk as it should be.
std::string mended(std::string png) {
  for (size_t at = kSignatureBytes; at + 12 <= png.size();) {
    const size_t length = get(png, at);
    if (length > png.size() - at - 12) break;
    put(png, at + 8 + length, crc32(std::string_view(png).substr(at + 4, length + 4)));
    at += length + 12;
  }
  return png;
}

std::string chunk(std::string_view type, std::string_view body) {
  std::string bytes(4, '\0');
  put(bytes, 0, static_cast<uint32_t>(body.size()));
  return bytes.append(type).append(body).append(4, '\0');
}

/// A head of 7 bytes: width, height, bits, colour type, interlacing and the lengths of a palette and its
/// transparency; then those, then the rows, not packed.
std::string png_of_parts(std::string_view bytes) {
  if (bytes.size() < 7) return "";
  std::string head(13, '\0');
  put(head, 0, static_cast<uint8_t>(bytes[0]) % 70);
  put(head, 4, static_cast<uint8_t>(bytes[1]) % 70);
  head[8] = bytes[2];
  head[9] = bytes[3];
  head[12] = bytes[4];
  std::string png = "\x89PNG\r\n\x1a\n" + chunk("IHDR", head);
  const size_t palette = static_cast<uint8_t>(bytes[5]), alpha = static_cast<uint8_t>(bytes[6]);
  bytes.remove_prefix(7);
  if (palette > 0) png += chunk("PLTE", bytes.substr(0, palette));
  bytes.remove_prefix(std::min(palette, bytes.size()));
  if (alpha > 0) png += chunk("tRNS", bytes.substr(0, alpha));
  bytes.remove_prefix(std::min(alpha, bytes.size()));
  const auto size = static_cast<uint16_t>(bytes.size());
  std::string data = {'\x78',
                      '\x01',
                      '\x01',
                      static_cast<char>(size),
                      static_cast<char>(size >> 8),
                      static_cast<char>(~size),
                      static_cast<char>(~size >> 8)};
  data.append(bytes).append(4, '\0');
  put(data, data.size() - 4, adler32(bytes));
  return mended(png + chunk("IDAT", data) + chunk("IEND", ""));
}

/// A line drawing as the program writes it.
std::string good_png() {
  LineMap map(21, 13);
  for (int x = 3; x < 18; ++x) map.set(x, 3 + x / 2);
  const fs::path path = scratch_folder() / "good.png";
  write_png(path, picture_of(map), {{"inkbench:version", "1"}});
  require(read_line_file(path).lines == map);
  return read_file(path);
}

std::string good_exr() {
  const fs::path path = scratch_folder() / "good.exr";
  write_exr(path, Image(9, 7, 1, 1.0F), {{"inkbench:version", "1"}});
  require(read_line_file(path, {.invert = Invert::no}).lines.count() == 63);
  return read_file(path);
}

std::string patched(std::string text, std::span<const uint8_t> patches) {
  for (; patches.size() >= 3; patches = patches.subspan(3))
    text[(patches[0] | patches[1] << 8) % text.size()] = static_cast<char>(patches[2]);
  return text;
}

std::string file_of(uint8_t choice, std::span<const uint8_t> content) {
  static const std::string png = good_png(), exr = good_exr();
  const std::string_view text(reinterpret_cast<const char*>(content.data()), content.size());
  switch (choice % 5) {
    case 0:
      return std::string(text);
    case 1:
      return mended(std::string(text));
    case 2:
      return mended(patched(png, content));
    case 3:
      return patched(exr, content);
    default:
      return png_of_parts(text);
  }
}

void feed(uint8_t choice, std::span<const uint8_t> content) {
  const fs::path path = scratch_folder() / "fuzz.png";
  const std::string file = file_of(choice, content);
  std::ofstream(path, std::ios::binary).write(file.data(), static_cast<std::streamsize>(file.size()));
  const LineMap map = read_line_file(path).lines;
  require(map.width_px() >= 1 && map.height_px() >= 1);
}

}  // namespace
}  // namespace inkbench

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  try {
    inkbench::feed(data[0], {data + 1, size - 1});
  } catch (const inkbench::Error&) {
    // Refusing bad input is right.
  }
  return 0;
}
