// SPDX-License-Identifier: MIT
// A line map: H x W bits, true = line, row 0 on top. What all measures look at: the lines a filter drew, or
// the reference lines. Packed 64 pixels a word, since the measures work on whole words wherever they can.
#pragma once

#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/image/image.h"

namespace inkbench {

struct Pixel {
  int x = 0, y = 0;
  bool operator==(const Pixel&) const = default;
};

/// The border that is ignored in prediction and reference.
inline constexpr int kIgnoredBorderPx = 2;

class LineMap {
 public:
  LineMap() = default;
  /// All false.
  LineMap(int width_px, int height_px)
      : width_px_(width_px),
        height_px_(height_px),
        words_per_row_((width_px + 63) / 64),
        words_(static_cast<size_t>(words_per_row_) * height_px) {
    assert(width_px >= 0 && height_px >= 0);
  }

  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }
  int words_per_row() const { return words_per_row_; }
  bool same_size(const LineMap& other) const {
    return width_px_ == other.width_px_ && height_px_ == other.height_px_;
  }
  bool contains(int x, int y) const { return x >= 0 && x < width_px_ && y >= 0 && y < height_px_; }

  bool at(int x, int y) const {
    assert(contains(x, y));
    return (row(y)[x >> 6] >> (x & 63)) & 1;
  }
  void set(int x, int y, bool value = true) {
    assert(contains(x, y));
    uint64_t& word = row(y)[x >> 6];
    const uint64_t bit = uint64_t{1} << (x & 63);
    word = value ? word | bit : word & ~bit;
  }

  /// One row's words: pixel x is bit x % 64 of word x / 64. Bits past the width are zero, and must stay so.
  std::span<uint64_t> row(int y) { return {words_.data() + offset(y), static_cast<size_t>(words_per_row_)}; }
  std::span<const uint64_t> row(int y) const {
    return {words_.data() + offset(y), static_cast<size_t>(words_per_row_)};
  }
  /// All rows, one after the other.
  std::span<uint64_t> words() { return words_; }
  std::span<const uint64_t> words() const { return words_; }

  /// The number of true pixels.
  int64_t count() const;
  bool operator==(const LineMap&) const = default;

 private:
  size_t offset(int y) const { return static_cast<size_t>(y) * words_per_row_; }

  int width_px_ = 0, height_px_ = 0, words_per_row_ = 0;
  std::vector<uint64_t> words_;
};

/// Calls `use(x)` for each set bit of `word`, whose bit 0 is pixel `first_x`, in order of x.
template <class Use>
void for_each_bit(uint64_t word, int first_x, Use&& use) {
  for (; word != 0; word &= word - 1) use(first_x + std::countr_zero(word));
}

/// Calls `use(x, y)` for each true pixel, row by row from the top, in order of x.
template <class Use>
void for_each_pixel(const LineMap& map, Use&& use) {
  for (int y = 0; y < map.height_px(); ++y) {
    const std::span<const uint64_t> row = map.row(y);
    for (int w = 0; w < map.words_per_row(); ++w) for_each_bit(row[w], 64 * w, [&](int x) { use(x, y); });
  }
}

/// The true pixels, row by row from the top, in order of x.
std::vector<Pixel> pixels_of(const LineMap& map);

/// The map with everything nearer than `border_px` to the image's edge set to false.
LineMap without_border(const LineMap& map, int border_px = kIgnoredBorderPx);

/// Pixels true in either. The sizes must be the same.
LineMap united(const LineMap& a, const LineMap& b);

/// Where values count as line.
struct LineCut {
  double value = 0.5;     ///< From there on; 0: whatever is above 0. Of 8 bits, 0.5 is "over 127".
  bool inverted = false;  ///< Dark lines on light: 1 - value is looked at.

  bool is_line(float sample) const;
};

/// The pixels of one channel (`image` has no other) that count as line.
LineMap line_map_from(const Image& image, const LineCut& cut = {});

/// White lines on black, one channel.
Picture picture_of(const LineMap& map);

}  // namespace inkbench
