// SPDX-License-Identifier: MIT
// The matching against Kuhn's algorithm on a list of all edges.
#include "studies/measures/matching.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "tests/unit/line_map_support.h"

namespace inkbench {
namespace {

/// Random walks, like thinned lines.
LineMap random_walks(int width, int height, int walks, std::mt19937& random) {
  LineMap map(width, height);
  for (int i = 0; i < walks; ++i) {
    int x = static_cast<int>(random() % width), y = static_cast<int>(random() % height);
    const int dx = static_cast<int>(random() % 3) - 1, dy = static_cast<int>(random() % 3) - 1;
    for (int step = 0; step < 40; ++step) {
      if (!map.contains(x, y)) break;
      map.set(x, y);
      x += random() % 4 == 0 ? static_cast<int>(random() % 3) - 1 : dx;
      y += random() % 4 == 0 ? static_cast<int>(random() % 3) - 1 : dy;
    }
  }
  return map;
}

class Kuhn {
 public:
  Kuhn(const LineMap& a, const LineMap& b, double tolerance) : edges_(a.count()), partner_(b.count(), -1) {
    const std::vector<Pixel> pa = pixels_of(a), pb = pixels_of(b);
    for (size_t i = 0; i < pa.size(); ++i) {
      for (size_t j = 0; j < pb.size(); ++j) {
        if (std::hypot(pa[i].x - pb[j].x, pa[i].y - pb[j].y) <= tolerance) edges_[i].push_back(j);
      }
    }
  }
  int64_t size() {
    int64_t pairs = 0;
    for (size_t i = 0; i < edges_.size(); ++i) {
      visited_.assign(partner_.size(), false);
      pairs += augment(i);
    }
    return pairs;
  }

 private:
  bool augment(size_t i) {
    for (const size_t j : edges_[i]) {
      if (visited_[j]) continue;
      visited_[j] = true;
      if (partner_[j] >= 0 && !augment(partner_[j])) continue;
      partner_[j] = static_cast<int>(i);
      return true;
    }
    return false;
  }
  std::vector<std::vector<size_t>> edges_;
  std::vector<int> partner_;
  std::vector<bool> visited_;
};

void expect_valid(const LineMap& a, const LineMap& b, double tolerance, const Matching& matching) {
  const std::vector<Pixel> pa = pixels_of(a), pb = pixels_of(b);
  ASSERT_EQ(matching.partner_of_a.size(), pa.size());
  ASSERT_EQ(matching.partner_of_b.size(), pb.size());
  int64_t pairs = 0;
  for (size_t i = 0; i < pa.size(); ++i) {
    const int j = matching.partner_of_a[i];
    if (j < 0) continue;
    ++pairs;
    EXPECT_EQ(matching.partner_of_b.at(j), static_cast<int>(i));
    EXPECT_LE(std::hypot(pa[i].x - pb[j].x, pa[i].y - pb[j].y), tolerance);
  }
  EXPECT_EQ(pairs, matching.pairs);
  EXPECT_EQ(pairs, static_cast<int64_t>(pb.size()) -
                       std::count(matching.partner_of_b.begin(), matching.partner_of_b.end(), -1));
}

void expect_maximal(const LineMap& a, const LineMap& b, double tolerance) {
  const Matching matching = matched(a, b, tolerance);
  expect_valid(a, b, tolerance, matching);
  EXPECT_EQ(matching.pairs, Kuhn(a, b, tolerance).size())
      << a.count() << " and " << b.count() << " pixels, tolerance " << tolerance;
}

TEST(Matching, is_maximal_on_random_maps) {
  std::mt19937 random(7);
  const int widths[] = {1, 5, 30, 63, 64, 65, 100, 130};
  for (int round = 0; round < 160; ++round) {
    const int width = widths[round % 8], height = 1 + static_cast<int>(random() % 40);
    const double densities[] = {0.01, 0.05, 0.15, 0.4};
    const LineMap a = random_map(width, height, densities[random() % 4], random);
    const LineMap b = random_map(width, height, densities[random() % 4], random);
    const double tolerances[] = {0, 1, 1.4143, 2, 3.5, 6, 10.86};
    expect_maximal(a, b, tolerances[round % 7]);
  }
}

TEST(Matching, is_maximal_on_lines) {
  std::mt19937 random(8);
  for (int round = 0; round < 60; ++round) {
    const LineMap a = random_walks(140, 100, 8, random), b = random_walks(140, 100, 8, random);
    for (const double tolerance : {1.0, 2.0, 5.0, 10.86}) expect_maximal(a, b, tolerance);
  }
}

/// What a greedy matching gets wrong: a chain along which all pairs must shift by one.
TEST(Matching, shifts_a_whole_chain_to_gain_one_pair) {
  LineMap a(300, 5), b(300, 5);
  for (int x = 10; x < 210; ++x) a.set(x, 2);
  for (int x = 11; x < 211; ++x) b.set(x, 2);
  EXPECT_EQ(matched(a, b, 1).pairs, 200);
  EXPECT_EQ(matched(b, a, 1).pairs, 200);
  LineMap zigzag(300, 5), spread(300, 5);
  for (int x = 10; x < 250; x += 3) zigzag.set(x, 1 + x % 2), spread.set(x + 2, 2);
  expect_maximal(zigzag, spread, 2);
  expect_maximal(zigzag, spread, 1);
}

TEST(Matching, does_not_depend_on_which_map_comes_first) {
  std::mt19937 random(9);
  for (int round = 0; round < 20; ++round) {
    const LineMap a = random_walks(200, 200, 20, random), b = random_walks(200, 200, 12, random);
    for (const double tolerance : {1.0, 2.0, 10.86}) {
      EXPECT_EQ(matched_count(a, b, tolerance), matched_count(b, a, tolerance));
    }
  }
}

TEST(Matching, doubled_line_matches_once) {
  LineMap doubled(100, 20), line(100, 20);
  for (int x = 0; x < 100; ++x) doubled.set(x, 9), doubled.set(x, 11), line.set(x, 10);
  EXPECT_EQ(matched_count(doubled, line, 2), 100);
  EXPECT_EQ(matched_count(doubled, line, 10), 100);
}

TEST(Matching, empty_maps_match_nothing) {
  LineMap empty(10, 10), dot(10, 10);
  dot.set(5, 5);
  EXPECT_EQ(matched(empty, empty, 2).pairs, 0);
  EXPECT_EQ(matched(empty, dot, 2).pairs, 0);
  EXPECT_EQ(matched(dot, empty, 2).pairs, 0);
  EXPECT_EQ(matched(dot, dot, 0).pairs, 1);
}

TEST(Matching, tolerance_is_inclusive) {
  for (int dy = 0; dy <= 12; ++dy) {
    for (int dx = 0; dx <= 12; ++dx) {
      LineMap a(30, 30), b(30, 30);
      a.set(15, 14);
      b.set(15 - dx, 14 + dy);
      for (const double tolerance : {0.0, 1.0, 2.0, 5.0, 10.0, 10.86}) {
        EXPECT_EQ(matched_count(a, b, tolerance), dx * dx + dy * dy <= tolerance * tolerance ? 1 : 0)
            << dx << ' ' << dy << ' ' << tolerance;
      }
    }
  }
}

TEST(Matching, tolerance_with_a_whole_square_is_not_lost_to_rounding) {
  EXPECT_EQ(squared_tolerance(2), 4);
  EXPECT_EQ(squared_tolerance(1.9999), 3);
  EXPECT_EQ(squared_tolerance(diagonal_tolerance_px(400, 400)), 18);  // 0.0075^2 x 320000
  EXPECT_EQ(squared_tolerance(diagonal_tolerance_px(1024, 1024)), 117);
  for (int64_t n = 0; n < 10000; ++n) EXPECT_EQ(squared_tolerance(std::sqrt(static_cast<double>(n))), n);
}

}  // namespace
}  // namespace inkbench
