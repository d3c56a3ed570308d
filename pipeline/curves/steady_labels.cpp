// SPDX-License-Identifier: MIT
#include "pipeline/curves/steady_labels.h"

#include <algorithm>
#include <functional>

namespace inkbench {
namespace {

/// The cheapest labels along an open line, by dynamic programming over its pixels.
class CheapestLabels {
 public:
  explicit CheapestLabels(std::span<const uint32_t> labels)
      : labels_(labels), kinds_(labels.begin(), labels.end()) {
    std::sort(kinds_.begin(), kinds_.end());
    kinds_.erase(std::unique(kinds_.begin(), kinds_.end()), kinds_.end());
  }

  std::vector<uint32_t> find() const {
    std::vector<uint32_t> result(labels_.begin(), labels_.end());
    if (kinds_.size() < 2) return result;
    std::vector<int> cost(kinds_.size(), 0);
    std::vector<size_t> cheapest_before(labels_.size(), 0);           // of all, at the pixel before
    std::vector<uint8_t> changes(labels_.size() * kinds_.size(), 0);  // is it cheaper to come from that one?
    for (size_t i = 0; i < labels_.size(); ++i) {
      const size_t cheapest = cheapest_of(cost);
      const int with_change = cost[cheapest] + kChangePx;
      cheapest_before[i] = cheapest;
      for (size_t k = 0; k < kinds_.size(); ++k) {
        if (i > 0 && with_change < cost[k]) {
          cost[k] = with_change;
          changes[i * kinds_.size() + k] = 1;
        }
        if (labels_[i] != kinds_[k]) ++cost[k];
      }
    }
    size_t k = cheapest_of(cost);
    for (size_t i = labels_.size(); i-- > 0;) {
      result[i] = kinds_[k];
      if (changes[i * kinds_.size() + k] != 0) k = cheapest_before[i];
    }
    return result;
  }

 private:
  static size_t cheapest_of(const std::vector<int>& cost) {
    return static_cast<size_t>(std::min_element(cost.begin(), cost.end()) - cost.begin());
  }

  std::span<const uint32_t> labels_;
  std::vector<uint32_t> kinds_;
};

}  // namespace

std::vector<uint32_t> steady_labels(std::span<const uint32_t> labels, bool ring) {
  std::vector<uint32_t> steady = CheapestLabels(labels).find();
  if (!ring) return steady;
  // Once more from where it changes, so that the ring's first pixel is no end.
  const auto change = std::adjacent_find(steady.begin(), steady.end(), std::not_equal_to<>());
  if (change == steady.end()) return steady;
  const auto start = change + 1 - steady.begin();
  std::vector<uint32_t> turned(labels.begin(), labels.end());
  std::rotate(turned.begin(), turned.begin() + start, turned.end());
  steady = CheapestLabels(turned).find();
  std::rotate(steady.rbegin(), steady.rbegin() + start, steady.rend());
  return steady;
}

}  // namespace inkbench
