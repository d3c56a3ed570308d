// SPDX-License-Identifier: MIT
// Which triangles meet along which edge. In: triangles between points. Out: their edges, sorted, so that
// those of one pair of points lie side by side.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace inkbench {

using Triangle = std::array<uint32_t, 3>;

/// Stands in a triangle's corners where it is left out.
inline constexpr uint32_t kNoPoint = std::numeric_limits<uint32_t>::max();

/// One triangle's use of an edge.
struct EdgeUse {
  uint32_t low = 0, high = 0;  ///< The edge's ends.
  uint32_t corner = 0;         ///< Where it starts: 3 x triangle + which of its corners.
  bool is_rising = false;      ///< It runs from `low` to `high`.

  uint32_t triangle() const { return corner / 3; }
};

inline uint32_t next_corner(uint32_t corner) {
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}

/// All uses, by their ends, then by their corners. Triangles that are left out have none. Time in proportion
/// to the triangles.
std::vector<EdgeUse> sorted_edges(const std::vector<Triangle>& triangles, size_t point_count);

/// Calls `visit(begin, end)` for each edge's range of uses.
template <class Visit>
void for_each_edge(const std::vector<EdgeUse>& uses, Visit&& visit) {
  for (size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    while (end < uses.size() && uses[end].low == uses[begin].low && uses[end].high == uses[begin].high) ++end;
    visit(begin, end);
  }
}

/// A forest over 0, 1, 2, ...; each tree's root is its smallest member.
class Forest {
 public:
  explicit Forest(size_t size);

  uint32_t root(uint32_t member) {
    while (parent_[member] != member) member = parent_[member] = parent_[parent_[member]];
    return member;
  }
  void join(uint32_t a, uint32_t b) {
    a = root(a);
    b = root(b);
    parent_[a < b ? b : a] = a < b ? a : b;
  }

 private:
  std::vector<uint32_t> parent_;
};

}  // namespace inkbench
