// SPDX-License-Identifier: MIT
// Thinning against Guo and Hall's conditions, written down pixel by pixel.
#include "pipeline/lines/thinning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "studies/measures/components.h"

#include "tests/unit/line_map_support.h"

namespace inkbench {
namespace {

/// Discs on random places: fat strokes with smooth and rough edges.
LineMap random_blobs(int width, int height, int count, uint32_t seed) {
  std::mt19937 random(seed);
  LineMap map(width, height);
  for (int i = 0; i < count; ++i) {
    const int cx = static_cast<int>(random() % width), cy = static_cast<int>(random() % height);
    const int radius = static_cast<int>(random() % 9);
    for (int y = std::max(0, cy - radius); y < std::min(height, cy + radius); ++y) {
      for (int x = std::max(0, cx - radius); x < std::min(width, cx + radius); ++x) {
        if ((x - cx) * (x - cx) + (y - cy) * (y - cy) <= radius * radius) map.set(x, y);
      }
    }
  }
  return map;
}

bool value(const LineMap& map, int x, int y) {
  return map.contains(x, y) && map.at(x, y);
}

/// x[1] to x[8]: the neighbours from the east counter-clockwise; x[9] is x[1] again.
std::array<bool, 10> neighbours(const LineMap& map, int x, int y) {
  const int dx[] = {1, 1, 0, -1, -1, -1, 0, 1}, dy[] = {0, -1, -1, -1, 0, 1, 1, 1};
  std::array<bool, 10> result{};
  for (int i = 0; i < 8; ++i) result[i + 1] = value(map, x + dx[i], y + dy[i]);
  result[9] = result[1];
  return result;
}

bool is_deleted(const std::array<bool, 10>& x, bool second) {
  int crossings = 0, n1 = 0, n2 = 0;
  for (int i = 1; i <= 4; ++i) {
    crossings += !x[2 * i - 1] && (x[2 * i] || x[2 * i + 1]);
    n1 += x[2 * i - 1] || x[2 * i];
    n2 += x[2 * i] || x[2 * i + 1];
  }
  const bool g1 = crossings == 1;
  const bool g2 = 2 <= std::min(n1, n2) && std::min(n1, n2) <= 3;
  const bool g3 = second ? !((x[6] || x[7] || !x[4]) && x[5]) : !((x[2] || x[3] || !x[8]) && x[1]);
  return g1 && g2 && g3;
}

/// Full sweeps: each sub-iteration decides on the whole image before it deletes.
LineMap thinned_by_definition(LineMap map) {
  for (bool changed = true; changed;) {
    changed = false;
    for (const bool second : {false, true}) {
      const LineMap before = map;
      for_each_pixel(before, [&](int x, int y) {
        if (!is_deleted(neighbours(before, x, y), second)) return;
        map.set(x, y, false);
        changed = true;
      });
    }
  }
  return map;
}

TEST(Thinning, equals_the_definition_on_random_maps) {
  const int widths[] = {1, 2, 3, 7, 63, 64, 65, 127, 128, 129, 200};
  uint32_t seed = 1;
  for (const int width : widths) {
    for (const double density : {0.02, 0.2, 0.5, 0.8, 0.97, 1.0}) {
      const LineMap map = random_map(width, 1 + static_cast<int>(seed * 7 % 40), density, seed);
      EXPECT_EQ(thinned(map), thinned_by_definition(map)) << width << " wide, density " << density;
      ++seed;
    }
  }
}

TEST(Thinning, equals_the_definition_on_fat_strokes) {
  for (uint32_t seed = 0; seed < 40; ++seed) {
    const LineMap map = random_blobs(150, 90, 60, seed);
    EXPECT_EQ(thinned(map), thinned_by_definition(map)) << seed;
  }
}

TEST(Thinning, bar_becomes_its_middle_line) {
  const LineMap bar = from_rows({"..........", ".########.", ".########.", ".########.", ".........."});
  const LineMap line = thinned(bar);
  EXPECT_EQ(component_count(line), 1);
  for_each_pixel(line, [](int, int y) { EXPECT_EQ(y, 2); });
  EXPECT_GE(line.count(), 5);
}

/// The result that scikit-image documents for its `thin`, the same algorithm.
TEST(Thinning, bar_with_a_tail_becomes_the_published_line) {
  const LineMap bar =
      from_rows({".#.....", "..###..", "..###..", "..###..", "..###..", "..###..", "......."});
  EXPECT_EQ(thinned(bar),
            from_rows({".#.....", "..#....", "...#...", "...#...", "...#...", ".......", "......."}));
}

TEST(Thinning, thin_things_stay) {
  const LineMap map =
      from_rows({"#.........", "..........", "..#####...", ".......#..", "........#.", "#........#"});
  EXPECT_EQ(thinned(map), map);
}

TEST(Thinning, keeps_parts_connected_and_apart) {
  for (uint32_t seed = 0; seed < 30; ++seed) {
    const LineMap blobs = random_blobs(130, 100, 40, seed + 100);
    EXPECT_EQ(component_count(thinned(blobs)), component_count(blobs)) << seed;
    const LineMap noise = random_map(130, 60, 0.35, seed);
    EXPECT_EQ(component_count(thinned(noise)), component_count(noise)) << seed;
  }
}

TEST(Thinning, thinned_map_stays_as_it_is) {
  const LineMap once = thinned(random_blobs(200, 200, 120, 5));
  EXPECT_EQ(thinned(once), once);
}

TEST(Thinning, everything_ink_becomes_a_line) {
  const LineMap full = random_map(200, 130, 1.0, 0);
  const LineMap line = thinned(full);
  EXPECT_EQ(component_count(line), 1);
  EXPECT_LT(line.count(), 200);
  EXPECT_EQ(line, thinned_by_definition(full));
}

}  // namespace
}  // namespace inkbench
