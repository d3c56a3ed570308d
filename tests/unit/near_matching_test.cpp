// SPDX-License-Identifier: MIT
// Matchings that go on from the last map, against matchings anew and against the rule that says which pixels
// pair, written down plainly.
#include "studies/measures/near_matching.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "studies/measures/distance.h"
#include "studies/measures/matching.h"
#include "tests/unit/line_map_support.h"

namespace inkbench {
namespace {

constexpr int kSide = 24;

/// The map with some pixels turned over, as from one threshold to the next.
LineMap slightly_changed(LineMap map, std::mt19937& random) {
  for (int i = 0; i < 12; ++i) {
    const int x = static_cast<int>(random() % kSide), y = static_cast<int>(random() % kSide);
    map.set(x, y, !map.at(x, y));
  }
  return map;
}

LineMap only(const std::vector<Pixel>& pixels) {
  LineMap map(kSide, kSide);
  for (const Pixel& pixel : pixels) map.set(pixel.x, pixel.y);
  return map;
}

/// Nearest first, each pixel that can be paired beside those taken before it.
LineMap nearest_paired(const LineMap& from, const LineMap& to, double tolerance_px) {
  std::vector<Pixel> order = pixels_of(from), taken;
  const std::vector<int64_t> distance = squared_distances(order, to);
  std::vector<std::pair<int64_t, Pixel>> sorted;
  for (size_t i = 0; i < order.size(); ++i) sorted.emplace_back(distance[i], order[i]);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [squared, pixel] : sorted) {
    taken.push_back(pixel);
    if (matched_count(only(taken), to, tolerance_px) != std::ssize(taken)) taken.pop_back();
  }
  return only(taken);
}

LineMap blank() {
  return {kSide, kSide};
}

TEST(NearMatching, finds_as_many_pairs_from_map_to_map_as_a_matching_anew) {
  for (uint32_t seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    const LineMap to = random_map(kSide, kSide, 0.02 + 0.01 * (seed % 12), random);
    const double tolerance = 0.7 * (seed % 8);
    NearMatching matching(to, tolerance);
    LineMap from = random_map(kSide, kSide, 0.15, random);
    for (int step = 0; step < 12; ++step, from = slightly_changed(from, random)) {
      LineMap paired = blank();
      const int64_t pairs = matching.match(from, paired);
      ASSERT_EQ(pairs, matched_count(from, to, tolerance)) << "seed " << seed << ", step " << step;
      ASSERT_EQ(paired.count(), pairs);
    }
  }
}

TEST(NearMatching, pairs_the_nearest_pixels_whatever_maps_came_before) {
  for (uint32_t seed = 0; seed < 12; ++seed) {
    std::mt19937 random(seed);
    const LineMap to = random_map(kSide, kSide, 0.06, random);
    const double tolerance = 1.0 + 0.5 * (seed % 5);
    NearMatching matching(to, tolerance);
    LineMap from = random_map(kSide, kSide, 0.15, random);
    for (int step = 0; step < 4; ++step, from = slightly_changed(from, random)) {
      LineMap paired = blank();
      matching.match(from, paired);
      ASSERT_EQ(paired, nearest_paired(from, to, tolerance)) << "seed " << seed << ", step " << step;
    }
  }
}

TEST(NearMatching, of_two_lines_beside_one_the_nearer_is_paired) {
  const LineMap to = from_rows({".......", ".......", "..###..", ".......", "......."});
  const LineMap from = from_rows({"..###..", ".......", ".......", "..###..", "......."});
  LineMap paired(7, 5);
  NearMatching(to, 2).match(from, paired);
  EXPECT_EQ(paired, from_rows({".......", ".......", ".......", "..###..", "......."}));
}

}  // namespace
}  // namespace inkbench
