// SPDX-License-Identifier: MIT
// A bounding volume hierarchy four boxes wide, which a ray tests at once. In: a box tree. Out: the items
// whose boxes a ray may meet. Source: Dammertz, Hanika and Keller, "Shallow bounding volume hierarchies for
// fast SIMD ray tracing of incoherent rays", 2008.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "pipeline/curves/box_tree.h"

namespace inkbench {

class WideTree {
 public:
  WideTree() = default;
  explicit WideTree(const BoxTree& tree);

  /// Calls `use(place)` with the places in `BoxTree::items` of a superset of what lies on origin + t
  /// direction for t from `from` to `to`, which `use` may lower.
  template <class Use>
  void walk(const glm::dvec3& origin, const glm::dvec3& direction, double from, const double& to,
            Use&& use) const {
    if (nodes_.empty()) return;
    WideRay ray;
    if (!enter(origin, direction, from, to, ray)) return;
    std::array<uint32_t, kStackSize> stack;
    size_t height = 0;
    stack[height++] = 0;
    while (height > 0) {
      const Node& node = nodes_[stack[--height]];
      const Four hit = meets(node, ray, static_cast<float>((to - ray.shift) * kOutwards));
      for (size_t i = 0; i < 4; ++i) {
        if (hit[i] == 0) continue;
        if (node.count[i] == 0) {
          stack[height++] = node.first[i];
        } else {
          for (uint32_t place = node.first[i]; place < node.first[i] + node.count[i]; ++place) use(place);
        }
      }
    }
  }

 private:
  using Floats = float __attribute__((vector_size(16)));
  using Four = int __attribute__((vector_size(16)));
  static constexpr size_t kStackSize = 3 * BoxTree::kMaxDepth + 1;
  /// A bound of time in single precision is this much later.
  static constexpr double kOutwards = 1.0 + 1e-6;

  /// Unused places have boxes that nothing meets.
  struct Node {
    std::array<Floats, 3> low, high;  ///< From the root's centre, made larger than what rounding can do.
    std::array<uint32_t, 4> first{}, count{};  ///< As `BoxTree::Node`, children by wide nodes.
  };
  /// The ray from where it enters the root's box, from the box's centre.
  struct WideRay {
    std::array<Floats, 3> origin, inverse;
    double shift = 0.0;  ///< Its t there.
  };

  bool enter(const glm::dvec3& origin, const glm::dvec3& direction, double from, double to,
             WideRay& ray) const;

  static Four meets(const Node& node, const WideRay& ray, float to) {
    Floats near{0.0F, 0.0F, 0.0F, 0.0F};
    Floats far{to, to, to, to};
    for (size_t axis = 0; axis < 3; ++axis) {
      const Floats a = (node.low[axis] - ray.origin[axis]) * ray.inverse[axis];
      const Floats b = (node.high[axis] - ray.origin[axis]) * ray.inverse[axis];
      const Floats first = a < b ? a : b;
      const Floats last = a < b ? b : a;
      near = first > near ? first : near;
      far = last < far ? last : far;
    }
    return near <= far;
  }

  uint32_t add(const BoxTree& tree, uint32_t from);

  std::vector<Node> nodes_;
  Box root_;
  glm::dvec3 centre_{0.0};
  float outwards_ = 0.0F;
};

}  // namespace inkbench
