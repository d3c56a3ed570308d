// SPDX-License-Identifier: MIT
#include "tests/fuzz/plain_lines.h"

#include <algorithm>
#include <vector>

namespace inkbench {
namespace {

/// Augmenting paths by brute force: rounds of depth-first searches over all pairs until a round gains
/// nothing.
class PlainMatching {
 public:
  PlainMatching(const LineMap& a, const LineMap& b, int64_t squared)
      : a_(pixels_of(a)), b_(pixels_of(b)), squared_(squared), of_a_(a_.size(), -1), of_b_(b_.size(), -1) {}

  int64_t size() {
    for (bool gained = true; gained;) {
      gained = false;
      visited_.assign(b_.size(), false);
      for (size_t i = 0; i < a_.size(); ++i) gained = (of_a_[i] < 0 && augment(i)) || gained;
    }
    return std::count_if(of_a_.begin(), of_a_.end(), [](int partner) { return partner >= 0; });
  }

 private:
  bool augment(size_t i) {
    for (size_t j = 0; j < b_.size(); ++j) {
      const int64_t dx = a_[i].x - b_[j].x, dy = a_[i].y - b_[j].y;
      if (visited_[j] || dx * dx + dy * dy > squared_) continue;
      visited_[j] = true;
      if (of_b_[j] >= 0 && !augment(static_cast<size_t>(of_b_[j]))) continue;
      of_a_[i] = static_cast<int>(j);
      of_b_[j] = static_cast<int>(i);
      return true;
    }
    return false;
  }

  std::vector<Pixel> a_, b_;
  int64_t squared_;
  std::vector<int> of_a_, of_b_;
  std::vector<bool> visited_;
};

}  // namespace

int64_t plain_matched(const LineMap& a, const LineMap& b, int64_t squared) {
  return PlainMatching(a, b, squared).size();
}

int64_t plain_parts(LineMap map) {
  int64_t parts = 0;
  for (const Pixel& start : pixels_of(map)) {
    if (!map.at(start.x, start.y)) continue;
    ++parts;
    for (std::vector<Pixel> open{start}; !open.empty();) {
      const Pixel p = open.back();
      open.pop_back();
      if (!map.contains(p.x, p.y) || !map.at(p.x, p.y)) continue;
      map.set(p.x, p.y, false);
      for (int i = 0; i < 9; ++i) open.push_back({p.x + i % 3 - 1, p.y + i / 3 - 1});
    }
  }
  return parts;
}

LineMap plain_far(const LineMap& from, const LineMap& to, int64_t squared) {
  LineMap far(from.width_px(), from.height_px());
  const std::vector<Pixel> others = pixels_of(to);
  for_each_pixel(from, [&](int x, int y) {
    far.set(x, y, std::none_of(others.begin(), others.end(), [&](const Pixel& other) {
              const int64_t dx = other.x - x, dy = other.y - y;
              return dx * dx + dy * dy <= squared;
            }));
  });
  return far;
}

}  // namespace inkbench
