// SPDX-License-Identifier: MIT
// Pieces of an outline that run over each other's ends become one path.
#include "pipeline/strokes/merge_overlaps.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "pipeline/strokes/join_curves.h"
#include "tests/unit/strokes_support.h"

namespace inkbench {
namespace {

std::vector<StrokePath> merged(std::vector<Curve> curves) {
  return merge_overlaps(join_curves(curves_of(std::move(curves)), default_stroke_classes(), true));
}

TEST(MergeOverlaps, pieces_that_run_over_each_others_ends_are_one_path) {
  const auto paths = merged({straight({0, 50}, {60, 50}), straight({54, 50.5F}, {120, 50.5F})});
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_NEAR(length_px(paths[0]), 120.0F, 0.5F);
}

TEST(MergeOverlaps, the_path_goes_over_without_a_step) {
  const auto paths = merged({straight({0, 50}, {60, 50}), straight({50, 51}, {120, 51})});
  ASSERT_EQ(paths.size(), 1U);
  for (size_t i = 1; i < paths[0].points.size(); ++i) {
    const glm::vec2 way = paths[0].points[i].at - paths[0].points[i - 1].at;
    EXPECT_LT(std::abs(way.y), 0.12F * way.x + 1e-3F);
  }
}

TEST(MergeOverlaps, a_piece_that_runs_back_is_no_part_of_it) {
  const auto paths = merged(
      {straight({0, 50}, {60, 50}), straight({60, 50.2F}, {52, 50.4F}), straight({52, 50.4F}, {120, 50.4F})});
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_NEAR(length_px(paths[0]), 120.0F, 0.5F);
}

TEST(MergeOverlaps, places_of_both_stay_once_and_in_order) {
  const auto paths = merged({straight({0, 50}, {60, 50}, 100), straight({50, 50}, {120, 50}, 200)});
  ASSERT_EQ(paths.size(), 1U);
  float before = -1.0F;
  for (const PlaceAlong& place : paths[0].places) {
    EXPECT_GT(place.along_px, before);
    before = place.along_px;
  }
  EXPECT_EQ(paths[0].places.size(), 13U);  // 100 to 105 and 201 to 207
}

TEST(MergeOverlaps, lines_that_cross_stay_apart) {
  EXPECT_EQ(merged({straight({0, 50}, {60, 50}), straight({58, 40}, {58, 100})}).size(), 2U);
}

TEST(MergeOverlaps, a_line_that_ends_beside_the_middle_of_another_stays) {
  EXPECT_EQ(merged({straight({0, 50}, {120, 50}), straight({60, 50.5F}, {20, 20})}).size(), 2U);
}

TEST(MergeOverlaps, a_ring_of_pieces_closes) {
  std::vector<Curve> arcs;
  for (int i = 0; i < 6; ++i) arcs.push_back(arc(50.0F, 60 * i, 60 * i + 66));
  const auto paths = merged(arcs);
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_TRUE(paths[0].is_closed);
  EXPECT_EQ(paths[0].points.front().at, paths[0].points.back().at);
  EXPECT_NEAR(length_px(paths[0]), 314.2F, 1.0F);
}

TEST(MergeOverlaps, creases_are_as_they_were) {
  Curve a = straight({0, 50}, {60, 50}), b = straight({54, 50}, {120, 50});
  a.curve_class = b.curve_class = CurveClass::crease;
  EXPECT_EQ(merged({a, b}).size(), 2U);
}

TEST(MergeOverlaps, a_short_piece_along_a_longer_path_is_left_out) {
  EXPECT_EQ(merged({straight({0, 50}, {120, 50}), straight({60, 51}, {66, 51})}).size(), 1U);
  EXPECT_EQ(merged({straight({0, 50}, {120, 50}), straight({60, 60}, {66, 60})}).size(), 2U);
}

}  // namespace
}  // namespace inkbench
