// SPDX-License-Identifier: MIT
#include "pipeline/mesh/triangle_edges.h"

#include <algorithm>
#include <numeric>

namespace inkbench {
namespace {

template <class Use>
void for_each_use(const std::vector<Triangle>& triangles, Use&& use) {
  for (uint32_t face = 0; face < triangles.size(); ++face) {
    const Triangle& t = triangles[face];
    if (t[0] == kNoPoint) continue;
    for (uint32_t i = 0; i < 3; ++i) {
      const uint32_t from = t[i], to = t[i == 2 ? 0 : i + 1];
      use(EdgeUse{std::min(from, to), std::max(from, to), 3 * face + i, from < to});
    }
  }
}

}  // namespace

std::vector<EdgeUse> sorted_edges(const std::vector<Triangle>& triangles, size_t point_count) {
  std::vector<uint32_t> starts(point_count + 1, 0);
  for_each_use(triangles, [&](const EdgeUse& use) { ++starts[use.low + 1]; });
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<EdgeUse> uses(starts.back());
  std::vector<uint32_t> filled(starts.begin(), starts.end() - 1);
  for_each_use(triangles, [&](const EdgeUse& use) { uses[filled[use.low]++] = use; });
  for (size_t point = 0; point < point_count; ++point) {
    std::sort(uses.begin() + starts[point], uses.begin() + starts[point + 1],
              [](const EdgeUse& a, const EdgeUse& b) {
                return a.high != b.high ? a.high < b.high : a.corner < b.corner;
              });
  }
  return uses;
}

Forest::Forest(size_t size) : parent_(size) {
  std::iota(parent_.begin(), parent_.end(), 0U);
}

}  // namespace inkbench
