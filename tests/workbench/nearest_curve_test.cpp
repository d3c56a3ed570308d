// SPDX-License-Identifier: MIT
// Which curve is meant, and what is said of it.
#include "app/workbench/nearest_curve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/workbench/curve_words.h"

namespace inkbench {
namespace {

using ::testing::ElementsAre;
using ::testing::Optional;

Curve pointed_line(glm::vec2 from, glm::vec2 to, int covered = 0) {
  Curve curve;
  curve.points = {from, to};
  curve.covered = covered;
  return curve;
}

Curves pointed_at(std::vector<Curve> list) {
  return {100, 100, std::move(list), {}};
}

TEST(NearestCurve, is_nearest_between_its_points_too) {
  const Curves curves = pointed_at({pointed_line({0, 0}, {0, 100}), pointed_line({10, 0}, {10, 100})});
  EXPECT_THAT(nearest_curve(curves, {6, 50}, 8, false), Optional(size_t{1}));
  EXPECT_THAT(nearest_curve(curves, {4, 50}, 8, false), Optional(size_t{0}));
}

TEST(NearestCurve, is_none_beyond_the_radius_and_one_at_it) {
  const Curves curves = pointed_at({pointed_line({0, 0}, {20, 0})});
  EXPECT_EQ(nearest_curve(curves, {10, 5.01F}, 5, false), std::nullopt);
  EXPECT_THAT(nearest_curve(curves, {10, 5}, 5, false), Optional(size_t{0}));
  EXPECT_EQ(nearest_curve(curves, {26, 0}, 5, false), std::nullopt) << "beyond its end";
}

TEST(NearestCurve, is_a_covered_one_only_where_those_are_shown) {
  const Curves curves = pointed_at({pointed_line({0, 1}, {20, 1}, 2), pointed_line({0, 4}, {20, 4})});
  EXPECT_THAT(nearest_curve(curves, {10, 0}, 9, false), Optional(size_t{1}));
  EXPECT_THAT(nearest_curve(curves, {10, 0}, 9, true), Optional(size_t{0}));
}

TEST(NearestCurve, is_the_visible_one_of_two_in_one_place) {
  const Curves curves = pointed_at({pointed_line({0, 0}, {20, 0}, 1), pointed_line({0, 0}, {20, 0})});
  EXPECT_THAT(nearest_curve(curves, {10, 3}, 9, true), Optional(size_t{1}));
}

TEST(CurveWords, say_class_object_length_cover_what_is_behind_and_ends) {
  Curve curve = pointed_line({0, 0}, {3, 4}, 2);
  curve.curve_class = CurveClass::apparent_ridge;
  curve.behind = Behind::other_object;
  curve.start = CurveEnd::crossing;
  curve.end = CurveEnd::cusp;
  EXPECT_THAT(curve_words(curve, "box"),
              ElementsAre("apparent ridge of box", "5.0 px, covered by 2 surfaces",
                          "another object behind it", "from a nearer outline to a cusp"));
}

TEST(CurveWords, leave_out_what_is_not_known) {
  Curve curve = pointed_line({0, 0}, {10, 0}, 0);
  curve.is_traced = true;
  curve.points.push_back({0, 0});
  EXPECT_THAT(curve_words(curve, ""),
              ElementsAre("silhouette, traced in the picture", "20.0 px, visible", "closed"));
}

}  // namespace
}  // namespace inkbench
