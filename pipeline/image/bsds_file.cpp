// SPDX-License-Identifier: MIT
#include "pipeline/image/bsds_file.h"

#include <fmt/format.h>
#include <libdeflate.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <memory>
#include <optional>
#include <string>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/memory_room.h"
#include "pipeline/base/text.h"
#include "pipeline/image/image_content.h"

namespace inkbench {
namespace {

constexpr size_t kHeadBytes = 128;
constexpr size_t kTagBytes = 8;

/// What elements are, by the format's numbers.
enum ElementType : uint32_t {
  kInt8 = 1,
  kUint8 = 2,
  kInt32 = 5,
  kUint32 = 6,
  kMatrix = 14,
  kCompressed = 15
};
enum MatrixClass : uint8_t { kCell = 1, kStructure = 2, kFirstNumeric = 6, kLastNumeric = 15 };

struct Damaged {};

struct Element {
  uint32_t type = 0;
  std::string_view data;
};

/// Reads elements one after the other. Throws Damaged where one does not fit.
class Elements {
 public:
  explicit Elements(std::string_view bytes) : rest_(bytes) {}

  bool done() const { return rest_.size() < kTagBytes; }

  Element next() {
    if (done()) throw Damaged{};
    const uint32_t first = number(rest_), small_size = first >> 16;
    if (small_size != 0) {
      if (small_size > 4) throw Damaged{};
      return take(first & 0xffff, 4, small_size, kTagBytes);
    }
    const size_t size = number(rest_.substr(4));
    // Compressed elements follow each other without padding.
    const size_t whole = kTagBytes + (first == kCompressed ? size : (size + 7) / 8 * 8);
    return take(first, kTagBytes, size, whole);
  }

  static uint32_t number(std::string_view bytes) {
    if (bytes.size() < sizeof(uint32_t)) throw Damaged{};
    uint32_t value = 0;
    std::memcpy(&value, bytes.data(), sizeof value);
    if constexpr (std::endian::native == std::endian::big) value = __builtin_bswap32(value);
    return value;
  }

 private:
  Element take(uint32_t type, size_t offset, size_t size, size_t whole) {
    if (offset + size > rest_.size()) throw Damaged{};
    const Element element{type, rest_.substr(offset, size)};
    rest_.remove_prefix(std::min(whole, rest_.size()));
    return element;
  }

  std::string_view rest_;
};

/// The head of a matrix; `rest` holds what follows it.
struct Matrix {
  uint8_t type = 0;
  std::vector<uint32_t> sides;
  std::string_view name;
  Elements rest;

  explicit Matrix(std::string_view data) : rest(data) {
    type = static_cast<uint8_t>(Elements::number(rest.next().data) & 0xff);
    const std::string_view dimensions = rest.next().data;
    for (size_t at = 0; at + 4 <= dimensions.size(); at += 4)
      sides.push_back(Elements::number(dimensions.substr(at)));
    name = rest.next().data;
  }

  bool is_numeric() const { return type >= kFirstNumeric && type <= kLastNumeric; }
};

/// The bytes of one number in an element of that type; 0 where it holds none.
size_t bytes_of(uint32_t element_type) {
  constexpr uint8_t kBytes[] = {0, 1, 1, 2, 2, 4, 4, 4, 0, 8, 0, 0, 8, 8};
  return element_type < std::size(kBytes) ? kBytes[element_type] : 0;
}

/// Columns follow each other; whatever the numbers' type, one whose bytes are all 0 is 0.
Picture picture_of(Matrix& matrix) {
  if (!matrix.is_numeric() || matrix.sides.size() != 2) throw Damaged{};
  const uint64_t height = matrix.sides[0], width = matrix.sides[1];
  const Element values = matrix.rest.next();
  const size_t size = bytes_of(values.type);
  const bool sides_are_sound = width > 0 && height > 0 && width <= kMaxSidePx && height <= kMaxSidePx;
  if (!sides_are_sound || size == 0 || values.data.size() != width * height * size) throw Damaged{};
  Picture picture(static_cast<int>(width), static_cast<int>(height), 1);
  const char* from = values.data.data();
  for (int x = 0; x < picture.width_px; ++x) {
    for (int y = 0; y < picture.height_px; ++y, from += size)
      picture.at(x, y) = std::any_of(from, from + size, [](char byte) { return byte != 0; }) ? 255 : 0;
  }
  return picture;
}

/// The names of a structure's fields.
std::vector<std::string> field_names(Matrix& structure) {
  const uint32_t length = Elements::number(structure.rest.next().data);
  const std::string_view text = structure.rest.next().data;
  if (length == 0) throw Damaged{};
  std::vector<std::string> names;
  for (size_t at = 0; at + length <= text.size(); at += length) {
    const std::string_view name = text.substr(at, length);
    names.emplace_back(name.substr(0, name.find('\0')));
  }
  return names;
}

void add_boundaries(std::string_view annotator, std::vector<Picture>& pictures) {
  Matrix structure(annotator);
  if (structure.type != kStructure) return;
  for (const std::string& name : field_names(structure)) {
    const Element field = structure.rest.next();
    if (name != "Boundaries" || field.type != kMatrix) continue;
    Matrix matrix(field.data);
    pictures.push_back(picture_of(matrix));
  }
}

/// How much deflate can pack at best.
constexpr size_t kMostPacked = 1032;

std::string unpacked(std::string_view packed, const fs::path& path) {
  const std::unique_ptr<libdeflate_decompressor, void (*)(libdeflate_decompressor*)> decompressor(
      libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
  const size_t most = std::min<size_t>(kMostImageBytes, kMostPacked * packed.size());
  for (size_t room = 16 * packed.size();; room *= 4) {
    check_memory(static_cast<double>(std::min(room, most)), path.string(), "unpacking it",
                 "choose a smaller file");
    std::string bytes(std::min(room, most), '\0');
    size_t size = 0;
    const libdeflate_result result = libdeflate_zlib_decompress(
        decompressor.get(), packed.data(), packed.size(), bytes.data(), bytes.size(), &size);
    bytes.resize(size);
    if (result == LIBDEFLATE_SUCCESS) return bytes;
    if (result != LIBDEFLATE_INSUFFICIENT_SPACE || room >= most) throw Damaged{};
  }
}

/// A variable of the file: adds what it holds, if it is the ground truth.
void add_variable(std::string_view data, std::vector<Picture>& pictures) {
  Matrix variable(data);
  if (variable.type != kCell || variable.name != "groundTruth") return;
  while (!variable.rest.done()) {
    const Element annotator = variable.rest.next();
    if (annotator.type == kMatrix) add_boundaries(annotator.data, pictures);
  }
}

void add_element(const Element& element, const fs::path& path, std::vector<Picture>& pictures) {
  if (element.type == kMatrix) return add_variable(element.data, pictures);
  if (element.type != kCompressed) return;
  const std::string bytes = unpacked(element.data, path);
  const Element inner = Elements(bytes).next();
  if (inner.type == kMatrix) add_variable(inner.data, pictures);
}

void check_head(const fs::path& path, std::string_view content) {
  if (!is_mat_file(content)) throw input_error(path.string(), "is no MATLAB file");
  if (content.starts_with("MATLAB 7.3"))
    throw input_error(path.string(), "is a MATLAB file of version 7.3, which is not read",
                      "save it with -v7, or give one image for each annotator");
  if (content.substr(126, 2) != "IM")
    throw input_error(path.string(), "is a MATLAB file of a machine with another order of bytes");
}

}  // namespace

bool is_mat_file(std::string_view content) {
  return content.size() >= kHeadBytes && content.starts_with("MATLAB ");
}

std::vector<Picture> read_bsds_boundaries(const fs::path& path) {
  const std::string content = read_file(path, kMostImageBytes);
  check_head(path, content);
  std::vector<Picture> pictures;
  try {
    for (Elements elements(std::string_view(content).substr(kHeadBytes)); !elements.done();)
      add_element(elements.next(), path, pictures);
  } catch (const Damaged&) {
    throw input_error(path.string(), "is damaged or cut off");
  }
  if (pictures.empty())
    throw input_error(path.string(), "holds no `groundTruth` with `Boundaries`",
                      "a MATLAB file must have the form of BSDS500's ground truth");
  for (const Picture& picture : pictures) {
    if (picture.width_px != pictures.front().width_px || picture.height_px != pictures.front().height_px)
      throw input_error(path.string(), "has drawings of different sizes");
  }
  return pictures;
}

}  // namespace inkbench
