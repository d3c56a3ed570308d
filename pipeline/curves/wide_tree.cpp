// SPDX-License-Identifier: MIT
#include "pipeline/curves/wide_tree.h"

#include <glm/geometric.hpp>

namespace inkbench {
namespace {

/// Of the root's diagonal: more than ten roundings of a coordinate within it.
constexpr double kOutwardsShare = 2e-6;
/// Instead of dividing by less, so that products stay finite.
constexpr double kLeastDirection = 1e-30;

}  // namespace

WideTree::WideTree(const BoxTree& tree) {
  if (tree.nodes().empty()) return;
  root_ = tree.nodes()[0].box;
  centre_ = 0.5 * (glm::dvec3(root_.low) + glm::dvec3(root_.high));
  const double diagonal = glm::length(glm::dvec3(root_.high) - glm::dvec3(root_.low));
  outwards_ = static_cast<float>(kOutwardsShare * diagonal);
  nodes_.reserve(tree.nodes().size() / 3 + 1);
  add(tree, 0);
}

uint32_t WideTree::add(const BoxTree& tree, uint32_t from) {
  // The node's children, of which the one with the largest box is opened until there are four.
  std::vector<uint32_t> parts{from};
  while (parts.size() < 4) {
    size_t largest = parts.size();
    float largest_size = -1.0F;
    for (size_t i = 0; i < parts.size(); ++i) {
      const BoxTree::Node& part = tree.nodes()[parts[i]];
      const glm::vec3 size = part.box.size();
      const float area = size.x * size.y + size.y * size.z + size.z * size.x;
      if (part.count > 0 || area <= largest_size) continue;
      largest = i;
      largest_size = area;
    }
    if (largest == parts.size()) break;
    const uint32_t first = tree.nodes()[parts[largest]].first;
    parts[largest] = first;
    parts.push_back(first + 1);
  }
  const auto index = static_cast<uint32_t>(nodes_.size());
  nodes_.emplace_back();
  for (size_t axis = 0; axis < 3; ++axis) {
    constexpr float kNowhere = 1e30F;
    for (size_t i = 0; i < 4; ++i) {
      const bool is_used = i < parts.size();
      const auto at = static_cast<int>(axis);
      nodes_[index].low[axis][i] =
          is_used ? static_cast<float>(tree.nodes()[parts[i]].box.low[at] - centre_[at]) - outwards_
                  : kNowhere;
      nodes_[index].high[axis][i] =
          is_used ? static_cast<float>(tree.nodes()[parts[i]].box.high[at] - centre_[at]) + outwards_
                  : kNowhere;
    }
  }
  for (size_t i = 0; i < parts.size(); ++i) {
    const BoxTree::Node& part = tree.nodes()[parts[i]];
    const uint32_t first = part.count > 0 ? part.first : add(tree, parts[i]);
    nodes_[index].first[i] = first;
    nodes_[index].count[i] = part.count;
  }
  return index;
}

bool WideTree::enter(const glm::dvec3& origin, const glm::dvec3& direction, double from, double to,
                     WideRay& ray) const {
  double near = from;
  double far = to;
  for (int axis = 0; axis < 3; ++axis) {
    const double along = std::abs(direction[axis]) < kLeastDirection
                             ? std::copysign(kLeastDirection, direction[axis])
                             : direction[axis];
    const double a = (root_.low[axis] - outwards_ - origin[axis]) / along;
    const double b = (root_.high[axis] + outwards_ - origin[axis]) / along;
    near = std::max(near, std::min(a, b));
    far = std::min(far, std::max(a, b));
    const auto inverse = static_cast<float>(1.0 / along);
    ray.inverse[static_cast<size_t>(axis)] = Floats{inverse, inverse, inverse, inverse};
  }
  if (!(near <= far)) return false;
  ray.shift = near;
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<float>(origin[axis] + near * direction[axis] - centre_[axis]);
    ray.origin[static_cast<size_t>(axis)] = Floats{at, at, at, at};
  }
  return true;
}

}  // namespace inkbench
