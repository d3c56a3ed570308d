// SPDX-License-Identifier: MIT
// The picture of what is right, missed and false.
#include "studies/measures/diff_picture.h"

#include <gtest/gtest.h>

#include <array>

namespace inkbench {
namespace {

using Colour = std::array<int, 3>;
constexpr Colour kBlack = {0, 0, 0}, kBlue = {0, 114, 178}, kVermillion = {213, 94, 0},
                 kWhite = {255, 255, 255};

Colour colour_at(const Picture& picture, int x, int y) {
  return {picture.at(x, y, 0), picture.at(x, y, 1), picture.at(x, y, 2)};
}

int count_of(const Picture& picture, const Colour& colour, int rows) {
  int count = 0;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < picture.width_px; ++x) count += colour_at(picture, x, y) == colour;
  }
  return count;
}

TEST(DiffPicture, every_pixel_of_both_lines_has_its_colour) {
  LineMap prediction(400, 60), reference(400, 60);
  for (int x = 20; x < 120; ++x) {
    prediction.set(x, 10), reference.set(x, 11);  // matched
    reference.set(x, 30);                         // missed
    prediction.set(x, 50);                        // false
  }
  const Picture picture = diff_picture(prediction, reference, 2);
  EXPECT_EQ(picture.width_px, 400);
  EXPECT_EQ(picture.height_px, 60 + kDiffLegendHeightPx);
  EXPECT_EQ(colour_at(picture, 70, 10), kBlack);
  EXPECT_EQ(colour_at(picture, 70, 11), kWhite);
  EXPECT_EQ(colour_at(picture, 70, 30), kBlue);
  EXPECT_EQ(colour_at(picture, 70, 50), kVermillion);
  EXPECT_EQ(count_of(picture, kBlack, 60), 100);
  EXPECT_EQ(count_of(picture, kBlue, 60), 100);
  EXPECT_EQ(count_of(picture, kVermillion, 60), 100);
  EXPECT_GT(count_of(picture, kBlack, 84), 200);  // the legend below
}

TEST(DiffPicture, small_images_have_no_legend) {
  for (const int side : {1, 3, 40}) {
    LineMap map(side, side);
    map.set(side / 2, side / 2);
    EXPECT_EQ(diff_picture(map, map, 2).height_px, side);
  }
}

}  // namespace
}  // namespace inkbench
