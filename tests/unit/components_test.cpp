// SPDX-License-Identifier: MIT
// Components and ends against flood filling and counting.
#include "studies/measures/components.h"

#include <gtest/gtest.h>

#include <random>
#include <string_view>

#include "tests/unit/line_map_support.h"

namespace inkbench {
namespace {

int64_t flood_filled(LineMap map) {
  int64_t count = 0;
  for (const Pixel& seed : pixels_of(map)) {
    if (!map.at(seed.x, seed.y)) continue;
    ++count;
    std::vector<Pixel> stack = {seed};
    while (!stack.empty()) {
      const auto [x, y] = stack.back();
      stack.pop_back();
      if (!map.contains(x, y) || !map.at(x, y)) continue;
      map.set(x, y, false);
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) stack.push_back({x + dx, y + dy});
      }
    }
  }
  return count;
}

TEST(Components, diagonal_neighbours_are_connected) {
  EXPECT_EQ(component_count(from_rows({"#..#", ".#..", "..#.", "#..."})), 3);
  EXPECT_EQ(component_count(from_rows({"#.#", ".#.", "#.#"})), 1);
  EXPECT_EQ(component_count(LineMap(5, 5)), 0);
}

TEST(Components, each_part_has_its_pixels_in_order) {
  const LineMap map = from_rows({"..#.", "#..#", "#..."});
  const std::vector<std::vector<Pixel>> parts = components_of(map);
  ASSERT_EQ(parts.size(), 2);
  EXPECT_EQ(parts[0], (std::vector<Pixel>{{2, 0}, {3, 1}}));
  EXPECT_EQ(parts[1], (std::vector<Pixel>{{0, 1}, {0, 2}}));
}

TEST(Components, parts_that_meet_late_are_one) {
  EXPECT_EQ(component_count(from_rows({"#.#.#.#", "#.#.#.#", "#######"})), 1);
  EXPECT_EQ(component_count(from_rows({"#...#", "#.#.#", "#.#.#", "###.#"})), 2);
}

TEST(Components, equal_flood_filling_on_random_maps) {
  std::mt19937 random(3);
  for (int round = 0; round < 60; ++round) {
    LineMap map(1 + static_cast<int>(random() % 140), 1 + static_cast<int>(random() % 60));
    std::bernoulli_distribution is_line(0.1 + 0.01 * round);
    for (int y = 0; y < map.height_px(); ++y) {
      for (int x = 0; x < map.width_px(); ++x) map.set(x, y, is_line(random));
    }
    EXPECT_EQ(component_count(map), flood_filled(map));
  }
}

TEST(Components, ends_have_exactly_one_neighbour) {
  EXPECT_EQ(end_count(from_rows({"......", ".####.", "......"})), 2);
  EXPECT_EQ(end_count(from_rows({"......", ".##...", "......"})), 2);
  EXPECT_EQ(end_count(from_rows({"...", ".#.", "..."})), 0);  // stands alone
  EXPECT_EQ(end_count(from_rows({".###.", "#...#", ".###."})), 0);
  EXPECT_EQ(end_count(from_rows({"#...#", ".#.#.", "..#..", "..#..", "..#.."})), 3);
  EXPECT_EQ(end_count(from_rows({"####"})), 2);  // beyond the image there is nothing
}

}  // namespace
}  // namespace inkbench
