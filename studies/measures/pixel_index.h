// SPDX-License-Identifier: MIT
// Numbers the true pixels of a line map 0, 1, 2, ... row by row, so that what belongs to pixels can lie in
// plain arrays. In: a map. Out: pixel to number and back, in memory that grows with words and true pixels.
#pragma once

#include "pipeline/lines/line_map.h"

namespace inkbench {

class PixelIndex {
 public:
  /// Keeps a copy of the pixels, not of the map.
  explicit PixelIndex(const LineMap& map) : pixels_(pixels_of(map)) {
    assert(pixels_.size() < INT32_MAX);
    before_.reserve(map.words().size());
    int32_t total = 0;
    for (const uint64_t word : map.words()) {
      before_.push_back(total);
      total += word == 0 ? 0 : std::popcount(word);
    }
  }

  int size() const { return static_cast<int>(pixels_.size()); }
  const std::vector<Pixel>& pixels() const { return pixels_; }
  Pixel pixel(int number) const { return pixels_[number]; }
  /// The number of the true pixel (x, y) of `map`, which must be the map that this was made from.
  int number(const LineMap& map, int x, int y) const {
    assert(map.at(x, y));
    const uint64_t below = map.row(y)[x >> 6] & ((uint64_t{1} << (x & 63)) - 1);
    return before_[static_cast<size_t>(y) * map.words_per_row() + (x >> 6)] + std::popcount(below);
  }

 private:
  std::vector<Pixel> pixels_;
  std::vector<int32_t> before_;  ///< For each word, how many pixels lie before it.
};

}  // namespace inkbench
