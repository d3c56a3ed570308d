// SPDX-License-Identifier: MIT
#include "studies/measures/components.h"

#include <algorithm>
#include <numeric>

#include "studies/measures/pixel_index.h"

namespace inkbench {
namespace {

class DisjointSets {
 public:
  explicit DisjointSets(int size) : parent_(size), count_(size) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  void join(int a, int b) {
    a = root(a);
    b = root(b);
    if (a == b) return;
    parent_[std::max(a, b)] = std::min(a, b);
    --count_;
  }
  int count() const { return count_; }
  /// The least member of the one's set.
  int root(int a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }

 private:
  std::vector<int> parent_;
  int count_;
};

DisjointSets joined_neighbours(const LineMap& map, const PixelIndex& index) {
  DisjointSets sets(index.size());
  for (int i = 0; i < index.size(); ++i) {
    const auto [x, y] = index.pixel(i);
    const auto join = [&](int nx, int ny) {
      if (map.contains(nx, ny) && map.at(nx, ny)) sets.join(i, index.number(map, nx, ny));
    };
    join(x - 1, y);  // The four neighbours that come earlier; the later ones join from their side.
    join(x - 1, y - 1);
    join(x, y - 1);
    join(x + 1, y - 1);
  }
  return sets;
}

}  // namespace

int64_t component_count(const LineMap& map) {
  return joined_neighbours(map, PixelIndex(map)).count();
}

std::vector<std::vector<Pixel>> components_of(const LineMap& map) {
  const PixelIndex index(map);
  DisjointSets sets = joined_neighbours(map, index);
  std::vector<std::vector<Pixel>> components;
  std::vector<size_t> place(static_cast<size_t>(index.size()));  // of the component that begins there
  for (int i = 0; i < index.size(); ++i) {
    const int first = sets.root(i);
    if (first == i) {
      place[first] = components.size();
      components.emplace_back();
    }
    const auto [x, y] = index.pixel(i);
    components[place[first]].push_back({x, y});
  }
  return components;
}

int64_t end_count(const LineMap& map) {
  int64_t ends = 0;
  for_each_pixel(map, [&](int x, int y) {
    int neighbours = 0;
    for (int ny = y - 1; ny <= y + 1; ++ny) {
      for (int nx = x - 1; nx <= x + 1; ++nx) {
        if ((nx != x || ny != y) && map.contains(nx, ny) && map.at(nx, ny)) ++neighbours;
      }
    }
    if (neighbours == 1) ++ends;
  });
  return ends;
}

}  // namespace inkbench
