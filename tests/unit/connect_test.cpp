// SPDX-License-Identifier: MIT
// What depends on how pixels connect: hysteresis, shortest length, taper.
#include "pipeline/passes/placing/connect.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/passes/placing/placed_lines.h"

namespace inkbench {
namespace {

void set(Image& placed, int x, int y, float strength) {
  set_placed(placed, x, y, {0, 0, EdgeClass::crease, std::min(strength, 1.0F)});
}
bool is_line(const Image& placed, int x, int y) {
  return placed.at(x, y, 2) > 0.0F;
}

TEST(Connect, weak_pixels_stay_where_their_line_reaches_the_limit) {
  Image placed(20, 8, 4);
  for (int x = 1; x < 8; ++x) set(placed, x, 2, 0.6F);
  set(placed, 8, 3, 1.0F);  // across a corner
  for (int x = 11; x < 19; ++x) set(placed, x, 2, 0.9F);
  const Image result = connected(placed, {.has_weak = true});
  for (int x = 1; x < 8; ++x) EXPECT_TRUE(is_line(result, x, 2));
  for (int x = 11; x < 19; ++x) EXPECT_FALSE(is_line(result, x, 2));
  EXPECT_TRUE(is_line(connected(placed, {}), 12, 2)) << "not asked for";
}

TEST(Connect, shorter_lines_are_left_out_and_diagonal_steps_are_longer) {
  Image placed(20, 8, 4);
  for (int x = 1; x < 5; ++x) set(placed, x, 1, 1.0F);       // 4 px
  for (int x = 8; x < 12; ++x) set(placed, x, x - 6, 1.0F);  // 3 sqrt(2) + 1 = 5.24 px
  const Image at_4 = connected(placed, {.min_length_px = 4.0F});
  EXPECT_TRUE(is_line(at_4, 1, 1) && is_line(at_4, 8, 2));
  const Image at_5 = connected(placed, {.min_length_px = 5.0F});
  EXPECT_FALSE(is_line(at_5, 1, 1));
  EXPECT_TRUE(is_line(at_5, 8, 2));
  EXPECT_FALSE(is_line(connected(placed, {.min_length_px = 5.3F}), 8, 2));
}

TEST(Connect, a_closed_line_is_as_long_as_its_way_around) {
  Image placed(12, 12, 4);
  for (int i = 1; i < 10; ++i) {
    set(placed, i, 1, 1.0F);
    set(placed, i, 9, 1.0F);
    set(placed, 1, i, 1.0F);
    set(placed, 9, i, 1.0F);
  }
  EXPECT_TRUE(is_line(connected(placed, {.min_length_px = 31.5F}), 5, 1));
  EXPECT_FALSE(is_line(connected(placed, {.min_length_px = 32.5F}), 5, 1));
}

TEST(Connect, width_grows_from_the_ends_and_closed_lines_have_none) {
  Image placed(30, 12, 4);
  for (int x = 2; x < 28; ++x) set(placed, x, 1, 3.0F);
  for (int i = 4; i < 9; ++i) {
    set(placed, i, 4, 3.0F);
    set(placed, i, 8, 3.0F);
    set(placed, 4, i, 3.0F);
    set(placed, 8, i, 3.0F);
  }
  const Image result = connected(placed, {.taper_px = 4.0F});
  EXPECT_NEAR(result.at(2, 1, 3), 0.5F / 4.0F, 1e-6);
  EXPECT_NEAR(result.at(4, 1, 3), 2.5F / 4.0F, 1e-6);
  EXPECT_NEAR(result.at(25, 1, 3), 2.5F / 4.0F, 1e-6);
  EXPECT_EQ(result.at(15, 1, 3), 1.0F);
  EXPECT_EQ(result.at(6, 4, 3), 1.0F);
}

TEST(PlacedLines, what_is_packed_is_read_within_a_250th_of_a_pixel) {
  Image packed(1, 1, 4);
  for (const float offset : {-0.499F, -0.25F, 0.0F, 0.13F, 0.499F}) {
    set_placed(packed, 0, 0, {offset, -offset, EdgeClass::material, 0.5F});
    const PlacedLine line = placed_at(packed, 0, 0);
    EXPECT_NEAR(line.offset_x, offset, 0.002F);
    EXPECT_NEAR(line.offset_y, -offset, 0.002F);
    EXPECT_EQ(line.line_class, EdgeClass::material);
  }
}

TEST(Connect, an_empty_image_stays_empty) {
  const Image empty(5, 4, 4);
  EXPECT_EQ(connected(empty, {true, 10.0F, 3.0F}), empty);
}

}  // namespace
}  // namespace inkbench
