// SPDX-License-Identifier: MIT
// A bounding volume hierarchy. In: a box for each item. Out: a tree of boxes that is walked to the items that
// matter. What rays, silhouettes, cuts and nearest lines are found with.
#pragma once

#include <array>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <vector>

namespace inkbench {

/// Empty where low > high.
struct Box {
  glm::vec3 low{std::numeric_limits<float>::infinity()};
  glm::vec3 high{-std::numeric_limits<float>::infinity()};

  void add(const glm::vec3& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  void add(const Box& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
  glm::vec3 size() const { return high - low; }
  bool touches(const Box& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y &&
           low.z <= other.high.z && other.low.z <= high.z;
  }
};

class BoxTree {
 public:
  /// An inner node's children are `first` and `first` + 1; a leaf's items are `items()[first]` to
  /// `items()[first + count - 1]`.
  struct Node {
    Box box;
    uint32_t first = 0;
    uint32_t count = 0;  ///< 0: an inner node.
  };

  BoxTree() = default;
  /// Split along the centres' longest side where the sum of the surfaces times the items in them is smallest
  /// (binned), into leaves of `leaf_size` items at most. Time n log n; the same boxes give the same tree.
  explicit BoxTree(std::span<const Box> boxes, uint32_t leaf_size = 2);

  /// Empty for no items. Children stand after their parents.
  const std::vector<Node>& nodes() const { return nodes_; }
  const std::vector<uint32_t>& items() const { return items_; }

  /// Calls `use(item)` for the items of all leaves to which `enter(node index)` leads.
  template <class Enter, class Use>
  void walk(Enter&& enter, Use&& use) const {
    if (nodes_.empty() || !enter(0U)) return;
    std::array<uint32_t, kMaxDepth> stack;
    size_t height = 0;
    uint32_t at = 0;
    for (;;) {
      const Node& node = nodes_[at];
      if (node.count > 0) {
        for (uint32_t i = node.first; i < node.first + node.count; ++i) use(items_[i]);
      } else {
        const bool left = enter(node.first);
        const bool right = enter(node.first + 1);
        if (left && right) stack[height++] = node.first + 1;
        if (left || right) {
          at = left ? node.first : node.first + 1;
          continue;
        }
      }
      if (height == 0) return;
      at = stack[--height];
    }
  }

  static constexpr size_t kMaxDepth = 64;

 private:
  std::vector<Node> nodes_;
  std::vector<uint32_t> items_;
};

}  // namespace inkbench
