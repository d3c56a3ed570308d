// SPDX-License-Identifier: MIT
#include "pipeline/curves/box_tree.h"

#include <algorithm>
#include <numeric>

namespace inkbench {
namespace {

constexpr int kBins = 16;
/// From here on nodes are cut in halves, so that no tree is deeper than a walk's stack.
constexpr size_t kDepthOfHalving = BoxTree::kMaxDepth / 2;

float half_area(const Box& box) {
  const glm::vec3 size = box.size();
  return size.x < 0.0F ? 0.0F : size.x * size.y + size.y * size.z + size.z * size.x;
}

struct Bin {
  Box box;
  uint32_t count = 0;
};

/// Items that have the centre's coordinate below `place` go left.
struct Cut {
  int axis = -1;
  float place = 0.0F;
};

class Builder {
 public:
  Builder(std::span<const Box> boxes, std::vector<BoxTree::Node>& nodes, std::vector<uint32_t>& items,
          uint32_t leaf_size)
      : boxes_(boxes), nodes_(nodes), items_(items), leaf_size_(leaf_size), centres_(boxes.size()) {
    for (size_t i = 0; i < boxes.size(); ++i) centres_[i] = 0.5F * (boxes[i].low + boxes[i].high);
  }

  void build() {
    nodes_.reserve(boxes_.size());
    nodes_.push_back(leaf(0, static_cast<uint32_t>(boxes_.size())));
    open_.push_back({0, 0});
    while (!open_.empty()) {
      const auto [node, depth] = open_.back();
      open_.pop_back();
      split(node, depth);
    }
  }

 private:
  struct Open {
    uint32_t node = 0;
    size_t depth = 0;
  };

  BoxTree::Node leaf(uint32_t first, uint32_t count) const {
    BoxTree::Node node{{}, first, count};
    for (uint32_t i = first; i < first + count; ++i) node.box.add(boxes_[items_[i]]);
    return node;
  }

  Cut best_cut(const BoxTree::Node& node) const {
    Box centres;
    for (uint32_t i = node.first; i < node.first + node.count; ++i) centres.add(centres_[items_[i]]);
    const glm::vec3 size = centres.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    if (!(size[axis] > 0.0F)) return {};
    std::array<Bin, kBins> bins{};
    const float scale = static_cast<float>(kBins) / size[axis];
    for (uint32_t i = node.first; i < node.first + node.count; ++i) {
      const float at = (centres_[items_[i]][axis] - centres.low[axis]) * scale;
      Bin& bin = bins[static_cast<size_t>(std::clamp(static_cast<int>(at), 0, kBins - 1))];
      bin.box.add(boxes_[items_[i]]);
      ++bin.count;
    }
    std::array<float, kBins> right_cost{};
    Bin right;
    for (size_t i = kBins - 1; i > 0; --i) {
      right.box.add(bins[i].box);
      right.count += bins[i].count;
      right_cost[i] = half_area(right.box) * static_cast<float>(right.count);
    }
    Bin left;
    Cut best;
    float least = std::numeric_limits<float>::infinity();
    for (size_t i = 1; i < kBins; ++i) {
      left.box.add(bins[i - 1].box);
      left.count += bins[i - 1].count;
      const float cost = half_area(left.box) * static_cast<float>(left.count) + right_cost[i];
      if (left.count == 0 || left.count == node.count || !(cost < least)) continue;
      least = cost;
      best = {axis, centres.low[axis] + static_cast<float>(i) / scale};
    }
    return best;
  }

  void split(uint32_t index, size_t depth) {
    const BoxTree::Node node = nodes_[index];
    if (node.count <= leaf_size_) return;
    const auto begin = items_.begin() + node.first;
    const auto end = begin + node.count;
    const Cut cut = depth < kDepthOfHalving ? best_cut(node) : Cut{};
    auto middle = cut.axis < 0 ? begin : std::partition(begin, end, [&](uint32_t item) {
      return centres_[item][cut.axis] < cut.place;
    });
    if (middle == begin || middle == end) {
      middle = begin + node.count / 2;
      const glm::vec3 size = node.box.size();
      const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
      std::nth_element(begin, middle, end, [&](uint32_t a, uint32_t b) {
        return centres_[a][axis] == centres_[b][axis] ? a < b : centres_[a][axis] < centres_[b][axis];
      });
    }
    const auto left_count = static_cast<uint32_t>(middle - begin);
    nodes_[index].first = static_cast<uint32_t>(nodes_.size());
    nodes_[index].count = 0;
    nodes_.push_back(leaf(node.first, left_count));
    nodes_.push_back(leaf(node.first + left_count, node.count - left_count));
    open_.push_back({nodes_[index].first, depth + 1});
    open_.push_back({nodes_[index].first + 1, depth + 1});
  }

  std::span<const Box> boxes_;
  std::vector<BoxTree::Node>& nodes_;
  std::vector<uint32_t>& items_;
  uint32_t leaf_size_;
  std::vector<glm::vec3> centres_;
  std::vector<Open> open_;
};

}  // namespace

BoxTree::BoxTree(std::span<const Box> boxes, uint32_t leaf_size) : items_(boxes.size()) {
  std::iota(items_.begin(), items_.end(), 0U);
  if (!boxes.empty()) Builder(boxes, nodes_, items_, leaf_size).build();
}

}  // namespace inkbench
