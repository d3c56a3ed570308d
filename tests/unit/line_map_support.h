// SPDX-License-Identifier: MIT
// Line maps to test with: drawn by hand, or random.
#pragma once

#include <initializer_list>
#include <random>
#include <string_view>

#include "pipeline/lines/line_map.h"

namespace inkbench {

/// One text a row, '#' where there is a line.
inline LineMap from_rows(std::initializer_list<std::string_view> rows) {
  LineMap map(static_cast<int>(rows.begin()->size()), static_cast<int>(rows.size()));
  int y = 0;
  for (const std::string_view row : rows) {
    for (int x = 0; x < map.width_px(); ++x) map.set(x, y, row[x] == '#');
    ++y;
  }
  return map;
}

/// Each pixel a line with probability `density`.
inline LineMap random_map(int width, int height, double density, std::mt19937& random) {
  std::bernoulli_distribution is_line(density);
  LineMap map(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) map.set(x, y, is_line(random));
  }
  return map;
}

inline LineMap random_map(int width, int height, double density, uint32_t seed) {
  std::mt19937 random(seed);
  return random_map(width, height, density, random);
}

}  // namespace inkbench
