// SPDX-License-Identifier: MIT
// Lines between objects, by small images.
#include "pipeline/lines/object_lines.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/unit/reference_support.h"

namespace inkbench {
namespace {

Image ids_from(const std::vector<std::string>& rows) {
  Image image(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), 1);
  for (int y = 0; y < image.height_px; ++y) {
    for (int x = 0; x < image.width_px; ++x)
      image.at(x, y) = rows[y][x] == '.' ? 0.0F : static_cast<float>(rows[y][x] - '0');
  }
  return image;
}

/// Depth falls as ids grow: object 3 is nearest.
Image depth_from(const Image& ids) {
  Image depth = ids;
  for (float& sample : depth.samples) sample = 1.0F - 0.1F * sample;
  return depth;
}

std::vector<Polyline> lines_of(const std::vector<std::string>& rows) {
  const Image ids = ids_from(rows);
  return object_lines(ids, depth_from(ids));
}

TEST(ReferenceObjectLines, rectangle_has_its_four_corners) {
  const std::vector<Polyline> lines = lines_of({"......", ".111..", ".111..", "......"});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].object_id, 1);
  EXPECT_TRUE(is_closed_line(lines[0]));
  EXPECT_EQ(length_of(lines[0]), 10.0);
  for (const glm::vec2 corner : {glm::vec2(1, 1), glm::vec2(4, 1), glm::vec2(4, 3), glm::vec2(1, 3)})
    EXPECT_EQ(distance_to(corner, lines), 0.0);
}

TEST(ReferenceObjectLines, image_border_is_no_line) {
  EXPECT_TRUE(lines_of({"1111", "1111", "1111"}).empty());
  const std::vector<Polyline> lines = lines_of({"11..", "11..", "11..", "11.."});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].points.size(), 2U);
  EXPECT_EQ(length_of(lines[0]), 4.0);
}

TEST(ReferenceObjectLines, nearer_object_owns_the_line) {
  EXPECT_EQ(lines_of({"2211", "2211", "2211"})[0].object_id, 2);
  const Image ids = ids_from({"2211", "2211", "2211"});
  Image depth(4, 3, 1, 0.5F);
  depth.at(2, 0) = 0.1F;
  EXPECT_EQ(object_lines(ids, depth)[0].object_id, 1);
}

TEST(ReferenceObjectLines, every_border_between_ids_is_in_one_line) {
  const std::vector<std::string> rows{"..1122..", ".111222.", ".133322.", "11333322", "..33.322", ".1..1..2"};
  const Image ids = ids_from(rows);
  int borders = 0;
  for (int y = 0; y < ids.height_px; ++y) {
    for (int x = 0; x < ids.width_px; ++x) {
      borders += x + 1 < ids.width_px && ids.at(x, y) != ids.at(x + 1, y) ? 1 : 0;
      borders += y + 1 < ids.height_px && ids.at(x, y) != ids.at(x, y + 1) ? 1 : 0;
    }
  }
  const double drawn = total_length(lines_of(rows));
  EXPECT_LE(drawn, borders);
  EXPECT_GT(drawn, borders - 8);  // lines of one or two px are dropped
}

TEST(ReferenceObjectLines, pixels_that_touch_at_a_corner_stay_apart) {
  const std::vector<Polyline> lines = lines_of({"....", ".1..", "..1.", "...."});
  ASSERT_EQ(lines.size(), 2U);
  for (const Polyline& line : lines) {
    EXPECT_TRUE(is_closed_line(line));
    EXPECT_EQ(length_of(line), 4.0);
  }
}

TEST(ReferenceObjectLines, line_ends_where_a_third_object_begins) {
  const std::vector<Polyline> lines = lines_of({"111222", "111222", "111222", "333333", "333333"});
  ASSERT_EQ(lines.size(), 3U);
  for (const Polyline& line : lines) EXPECT_EQ(length_of(line), 3.0);
}

TEST(ReferenceObjectLines, lines_under_three_pixels_are_dropped) {
  EXPECT_TRUE(lines_of({"1...", "....", "...."}).empty());
  EXPECT_EQ(lines_of({".1..", "....", "...."}).size(), 1U);
}

}  // namespace
}  // namespace inkbench
