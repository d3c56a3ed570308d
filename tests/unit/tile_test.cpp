// SPDX-License-Identifier: MIT
#include "studies/report/grid_tile.h"

#include <gtest/gtest.h>

#include "studies/report/scaling.h"

namespace inkbench {
namespace {

constexpr int kGapPx = 4;

Picture noise(int width, int height, uint32_t seed) {
  Picture picture(width, height, 3);
  for (uint8_t& sample : picture.samples) {
    seed = seed * 1664525U + 1013904223U;
    sample = static_cast<uint8_t>(seed >> 24);
  }
  return picture;
}

struct Case {
  int pictures, width, height, drawn_width, drawn_height;
};

class Tiles : public testing::TestWithParam<Case> {
 protected:
  /// Each picture with the gap that follows it, and the whole cell.
  std::pair<std::vector<Tile>, Picture> make() const {
    const auto [count, width, height, drawn_width, drawn_height] = GetParam();
    const int cell_width = count * (width + kGapPx) - kGapPx;
    Picture cell(cell_width, height, 3, 255);
    std::vector<Tile> tiles;
    for (int i = 0; i < count; ++i) {
      const int first = i * (width + kGapPx), end = std::min(cell_width, first + width + kGapPx);
      const Picture picture = noise(width, height, static_cast<uint32_t>(i + 1));
      for (int y = 0; y < height; ++y) std::copy_n(&picture.at(0, y), width * 3, &cell.at(first, y));
      tiles.push_back(make_tile(picture, {cell_width, height, drawn_width, drawn_height, first, end}));
    }
    return {tiles, cell};
  }
};

TEST_P(Tiles, joined_they_are_the_cell_scaled_as_a_whole) {
  const auto [tiles, cell] = make();
  EXPECT_EQ(joined(tiles), scaled(cell, GetParam().drawn_width, GetParam().drawn_height));
}

INSTANTIATE_TEST_SUITE_P(All, Tiles,
                         testing::Values(Case{1, 97, 61, 97, 61}, Case{1, 97, 61, 40, 25},
                                         Case{1, 30, 20, 90, 60}, Case{3, 97, 61, 299, 61},
                                         Case{3, 97, 61, 101, 21}, Case{3, 97, 61, 60, 12},
                                         Case{2, 50, 50, 104, 50}, Case{2, 46, 20, 48, 10},
                                         Case{5, 3, 9, 4, 2}, Case{7, 2, 9, 3, 2}, Case{4, 5, 9, 1, 1}));

TEST(Tile, keeps_few_columns_beside_what_is_drawn) {
  const Tile tile = make_tile(noise(1000, 10, 1), {3008, 10, 700, 3, 1004, 2008});
  EXPECT_GT(tile.left.width_px + tile.right.width_px, 0);
  EXPECT_LE(tile.left.width_px + tile.right.width_px, 10);
}

TEST(Tile, picture_of_another_size_is_cut_or_stands_on_white) {
  const TilePlace place{8, 6, 8, 6, 0, 8};
  const Picture large = joined({make_tile(Picture(20, 20, 3, 7), place)});
  EXPECT_EQ(large, Picture(8, 6, 3, 7));
  const Picture small = joined({make_tile(Picture(2, 20, 3, 7), place)});
  EXPECT_EQ(small.at(1, 5), 7);
  EXPECT_EQ(small.at(2, 5), 255);
}

}  // namespace
}  // namespace inkbench
