// SPDX-License-Identifier: MIT
// The disc of pixels around a pixel, and what of a line map lies in it, word by word. In: a squared radius.
// Out: spans of columns, calls with bits.
#pragma once

#include <algorithm>
#include <cmath>

#include "pipeline/lines/line_map.h"

namespace inkbench {

/// The disc of pixels within the tolerance, as one span of columns for each row.
class Disc {
 public:
  explicit Disc(int64_t radius_squared) : radius_(whole_root(radius_squared)) {
    for (int64_t dy = -radius_; dy <= radius_; ++dy) {
      half_widths_.push_back(whole_root(radius_squared - dy * dy));
    }
  }
  int radius() const { return radius_; }
  int half_width(int dy) const { return half_widths_[dy + radius_]; }

 private:
  static int whole_root(int64_t value) {
    auto root = static_cast<int64_t>(std::sqrt(static_cast<double>(value)));
    while (root * root > value) --root;
    while ((root + 1) * (root + 1) <= value) ++root;
    return static_cast<int>(root);
  }

  int radius_;
  std::vector<int> half_widths_;
};

/// Calls `use(bits, w, y)` for each word with true pixels in the disc around `centre`, `bits` being those in
/// the disc, row by row, until `use` returns true; returns whether it did.
template <class Use>
bool any_word_in_disc(const LineMap& map, const Disc& disc, const Pixel& centre, Use&& use) {
  const int first_y = std::max(0, centre.y - disc.radius());
  const int last_y = std::min(map.height_px() - 1, centre.y + disc.radius());
  for (int y = first_y; y <= last_y; ++y) {
    const int half = disc.half_width(y - centre.y);
    const int first = std::max(0, centre.x - half), last = std::min(map.width_px() - 1, centre.x + half);
    const std::span<const uint64_t> row = map.row(y);
    for (int w = first >> 6; w <= last >> 6; ++w) {
      uint64_t bits = row[w];
      if (w == first >> 6) bits &= ~uint64_t{0} << (first & 63);
      if (w == last >> 6) bits &= ~uint64_t{0} >> (63 - (last & 63));
      if (bits != 0 && use(bits, w, y)) return true;
    }
  }
  return false;
}

}  // namespace inkbench
