// SPDX-License-Identifier: MIT
// The course of strokes: which curves one stroke draws, and where its points lie.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "pipeline/strokes/bridge_gaps.h"
#include "pipeline/strokes/join_curves.h"
#include "pipeline/strokes/sample_path.h"
#include "pipeline/strokes/smooth_path.h"
#include "tests/unit/strokes_support.h"
#include "tests/unit/support.h"

namespace inkbench {
namespace {

/// Two curves of a chain that meet at (50, 0), the second of another class.
std::vector<Curve> two_classes() {
  Curve first = straight({0, 0}, {50, 0}), second = straight({50, 0}, {100, 0});
  second.curve_class = CurveClass::crease;
  first.chain = second.chain = 7;
  first.end = second.start = CurveEnd::other_class;
  return {first, second};
}

float length_of(const Stroke& stroke) {
  float length = 0.0F;
  for (size_t i = 1; i < stroke.points.size(); ++i)
    length += glm::distance(stroke.points[i - 1].at, stroke.points[i].at);
  return length;
}

StrokePath path_of(const Curve& curve) {
  return join_curves(curves_of({curve}), default_stroke_classes(), true).front();
}

TEST(StrokeJoining, a_chain_that_changes_its_class_is_one_stroke) {
  const Strokes strokes = strokes_of(two_classes());
  ASSERT_EQ(strokes.strokes.size(), 1U);
  EXPECT_EQ(strokes.strokes[0].points.front().curve_class, CurveClass::silhouette);
  EXPECT_EQ(strokes.strokes[0].points.back().curve_class, CurveClass::crease);
}

TEST(StrokeJoining, what_is_covered_differently_stays_apart) {
  std::vector<Curve> curves = two_classes();
  curves[1].covered = 1;
  StrokeParams params;
  params.hidden = true;
  params.dash_gap = 0.0F;
  EXPECT_EQ(strokes_of(curves, params).strokes.size(), 2U);
}

TEST(StrokeJoining, covered_curves_are_drawn_only_when_asked_for) {
  Curve curve = straight({0, 0}, {50, 0});
  curve.covered = 2;
  StrokeParams params;
  EXPECT_TRUE(strokes_of({curve}, params).strokes.empty());
  params.hidden = true;
  EXPECT_FALSE(strokes_of({curve}, params).strokes.empty());
}

TEST(StrokeJoining, a_class_without_width_makes_no_stroke) {
  StrokeClasses classes = default_stroke_classes();
  classes[static_cast<size_t>(CurveClass::crease)].width = 0.0F;
  const Strokes strokes = make_strokes(curves_of(two_classes()), {}, classes, {});
  ASSERT_EQ(strokes.strokes.size(), 1U);
  EXPECT_NEAR(length_of(strokes.strokes[0]), 50.0F, 1e-3F);
}

TEST(StrokeJoining, most_of_an_outlines_length_decides) {
  Curve longer = straight({0, 0}, {60, 0}), shorter = straight({60, 0}, {100, 0});
  longer.chain = shorter.chain = 7;
  longer.end = shorter.start = CurveEnd::other_class;
  longer.behind = Behind::nothing;
  shorter.behind = Behind::same_object;
  EXPECT_TRUE(strokes_of({longer, shorter}).strokes.at(0).is_outline);
  std::swap(longer.behind, shorter.behind);
  EXPECT_FALSE(strokes_of({longer, shorter}).strokes.at(0).is_outline);
}

TEST(StrokeJoining, a_strokes_number_does_not_hang_on_the_order_of_curves) {
  const Curve a = straight({0, 0}, {50, 0}, 100), b = straight({0, 50}, {50, 50}, 200);
  const Strokes one = strokes_of({a, b}), other = strokes_of({b, a});
  EXPECT_EQ(one.strokes[0].number, other.strokes[1].number);
  EXPECT_NE(one.strokes[0].number, one.strokes[1].number);
}

TEST(StrokeBridging, ends_that_go_on_in_each_others_direction_are_joined) {
  StrokeParams params;
  params.bridge = 10.0F;
  const Strokes strokes = strokes_of({straight({0, 0}, {50, 0}), straight({58, 1}, {100, 1})}, params);
  ASSERT_EQ(strokes.strokes.size(), 1U);
  EXPECT_NEAR(length_of(strokes.strokes[0]), 100.0F, 0.5F);
}

TEST(StrokeBridging, the_direction_of_the_curves_is_of_no_account) {
  StrokeParams params;
  params.bridge = 10.0F;
  EXPECT_EQ(strokes_of({straight({50, 0}, {0, 0}), straight({100, 1}, {58, 1})}, params).strokes.size(), 1U);
}

TEST(StrokeBridging, ends_that_turn_away_stay_apart) {
  StrokeParams params;
  params.bridge = 10.0F;
  EXPECT_EQ(strokes_of({straight({0, 0}, {50, 0}), straight({55, 0}, {55, 50})}, params).strokes.size(), 2U);
}

TEST(StrokeBridging, parallel_lines_side_by_side_stay_apart) {
  StrokeParams params;
  params.bridge = 10.0F;
  EXPECT_EQ(strokes_of({straight({0, 0}, {50, 0}), straight({50, 8}, {100, 8})}, params).strokes.size(), 2U);
}

TEST(StrokeBridging, of_two_ways_on_the_straighter_one_is_taken) {
  StrokeParams params;
  params.bridge = 10.0F;
  const Strokes strokes = strokes_of(
      {straight({0, 0}, {50, 0}), straight({56, 3}, {100, 30}), straight({56, 0}, {100, 0})}, params);
  ASSERT_EQ(strokes.strokes.size(), 2U);
  EXPECT_NEAR(length_of(strokes.strokes[0]), 100.0F, 0.1F);
}

TEST(StrokeBridging, four_arcs_of_a_circle_make_one_closed_stroke) {
  std::vector<Curve> arcs;
  for (int i = 0; i < 4; ++i) arcs.push_back(arc(50.0F, 90 * i, 90 * i + 84));
  StrokeParams params;
  params.bridge = 8.0F;
  const Strokes strokes = strokes_of(arcs, params);
  ASSERT_EQ(strokes.strokes.size(), 1U);
  EXPECT_TRUE(strokes.strokes[0].is_closed);
  for (const StrokePoint& point : strokes.strokes[0].points)
    EXPECT_NEAR(glm::distance(point.at, glm::vec2(100.0F)), 50.0F, 0.1F);
}

TEST(StrokeBridging, different_objects_stay_apart) {
  Curve other = straight({55, 0}, {100, 0});
  other.object_id = 2;
  StrokeParams params;
  params.bridge = 10.0F;
  EXPECT_EQ(strokes_of({straight({0, 0}, {50, 0}), other}, params).strokes.size(), 2U);
}

TEST(StrokeCourse, shorter_strokes_are_left_out) {
  StrokeParams params;
  params.shortest = 30.0F;
  EXPECT_EQ(strokes_of({straight({0, 0}, {29, 0}), straight({0, 9}, {31, 9})}, params).strokes.size(), 1U);
}

TEST(StrokeCourse, smoothing_keeps_ends) {
  std::vector<glm::vec2> zigzag;
  for (int i = 0; i <= 40; ++i) zigzag.emplace_back(4.0F * static_cast<float>(i), i % 2 == 0 ? 0.0F : 3.0F);
  const StrokePath path = path_of(make_curve(zigzag)), smooth = smoothed(path, 8.0F);
  EXPECT_EQ(smooth.points.front().at, path.points.front().at);
  EXPECT_EQ(smooth.points.back().at, path.points.back().at);
}

TEST(StrokeCourse, smoothing_evens_a_zigzag) {
  std::vector<glm::vec2> zigzag;
  for (int i = 0; i <= 40; ++i) zigzag.emplace_back(4.0F * static_cast<float>(i), i % 2 == 0 ? 0.0F : 3.0F);
  const StrokePath smooth = smoothed(path_of(make_curve(zigzag)), 8.0F);
  EXPECT_NEAR(length_px(smooth), 160.0F, 2.0F);
}

TEST(StrokeCourse, smoothing_a_straight_line_changes_nothing) {
  const StrokePath smooth = smoothed(path_of(straight({3, 4}, {83, 44})), 5.0F);
  for (const PathPoint& point : smooth.points)
    EXPECT_NEAR(point.at.y - 4.0F, 0.5F * (point.at.x - 3.0F), 1e-3F);
}

TEST(StrokeCourse, smoothing_a_circle_keeps_it_round_and_closed) {
  const StrokePath smooth = smoothed(path_of(arc(50.0F, 0, 360)), 3.0F);
  EXPECT_EQ(smooth.points.front().at, smooth.points.back().at);
  for (const PathPoint& point : smooth.points)
    EXPECT_NEAR(glm::distance(point.at, glm::vec2(100.0F)), 50.0F, 0.15F);
}

TEST(StrokeCourse, smoothing_moves_places_with_the_path) {
  const StrokePath smooth = smoothed(path_of(straight({0, 0}, {100, 0}, 500)), 4.0F);
  ASSERT_EQ(smooth.places.size(), 11U);
  for (size_t i = 0; i < 11; ++i)
    EXPECT_NEAR(smooth.places[i].along_px, 10.0F * static_cast<float>(i), 1e-2F);
}

TEST(StrokeCourse, samples_stay_on_the_curve_and_are_not_far_apart) {
  const Stroke stroke = strokes_of({arc(20.0F, 0, 300)}).strokes.at(0);
  for (size_t i = 1; i < stroke.points.size(); ++i) {
    const glm::vec2 a = stroke.points[i - 1].at, b = stroke.points[i].at;
    EXPECT_LE(glm::distance(a, b), 3.01F);
    EXPECT_NEAR(glm::distance(0.5F * (a + b), glm::vec2(100.0F)), 20.0F, 0.06F);
  }
}

TEST(StrokeCourse, corners_stay) {
  const Stroke stroke = strokes_of({make_curve({{0, 0}, {40.5F, 0}, {40.5F, 30}})}).strokes.at(0);
  EXPECT_THAT(stroke.points,
              testing::Contains(testing::Field(&StrokePoint::at, testing::Eq(glm::vec2(40.5F, 0.0F)))));
}

TEST(StrokeCourse, overshoot_goes_on_straight_beyond_both_ends) {
  StrokeParams params;
  params.overshoot = 5.0F;
  const Stroke stroke = strokes_of({straight({10, 0}, {60, 0})}, params).strokes.at(0);
  EXPECT_NEAR(stroke.points.front().at.x, 5.0F, 1e-3F);
  EXPECT_NEAR(stroke.points.back().at.x, 65.0F, 1e-3F);
  EXPECT_FLOAT_EQ(stroke.start_px, -5.0F);
}

TEST(StrokeCourse, where_the_view_ends_nothing_is_added) {
  Curve curve = straight({10, 0}, {60, 0});
  curve.end = CurveEnd::frame;
  StrokeParams params;
  params.overshoot = 5.0F;
  EXPECT_FLOAT_EQ(strokes_of({curve}, params).strokes.at(0).points.back().at.x, 60.0F);
}

TEST(StrokeWobble, strays_by_no_more_than_it_says) {
  StrokeParams params;
  params.wobble = 3.0F;
  float most = 0.0F;
  const Strokes strokes = strokes_of({straight({0, 50}, {199, 50})}, params);
  for (const StrokePoint& point : strokes.strokes.at(0).points)
    most = std::max(most, std::abs(point.at.y - 50.0F));
  EXPECT_LE(most, 3.0F);
  EXPECT_GT(most, 0.5F);
}

TEST(StrokeWobble, moves_with_the_line_and_does_not_boil) {
  StrokeParams params;
  params.wobble = 3.0F;
  const Strokes here = strokes_of({straight({0, 50}, {150, 50}, 900)}, params);
  const Strokes there = strokes_of({straight({7, 60}, {157, 60}, 900)}, params);
  for (size_t i = 0; i < here.strokes[0].points.size(); ++i) {
    const glm::vec2 moved = there.strokes[0].points[i].at - here.strokes[0].points[i].at;
    EXPECT_NEAR(glm::distance(moved, glm::vec2(7.0F, 10.0F)), 0.0F, 1e-4F);
  }
}

TEST(StrokeWobble, another_seed_is_another_hand) {
  StrokeParams params, other;
  params.wobble = other.wobble = 3.0F;
  other.seed = 2;
  const Curve curve = straight({0, 50}, {150, 50});
  EXPECT_NE(strokes_of({curve}, params).strokes[0].points[9].at,
            strokes_of({curve}, other).strokes[0].points[9].at);
}

TEST(StrokeWobble, a_closed_stroke_closes_without_a_step) {
  StrokeParams params;
  params.wobble = 6.0F;
  const Stroke stroke = strokes_of({arc(60.0F, 0, 360)}, params).strokes.at(0);
  EXPECT_EQ(stroke.points.front().at, stroke.points.back().at);
  const size_t last = stroke.points.size() - 1;
  EXPECT_LT(glm::distance(stroke.points[last].at, stroke.points[last - 1].at), 5.0F);
}

TEST(StrokePasses, each_stroke_is_drawn_so_often_and_the_first_time_where_it_is) {
  StrokeParams once, thrice;
  thrice.passes = 3;
  thrice.spread = 4.0F;
  const Curve curve = straight({0, 50}, {150, 50});
  const Strokes strokes = strokes_of({curve}, thrice);
  ASSERT_EQ(strokes.strokes.size(), 3U);
  for (const StrokePoint& point : strokes.strokes[0].points) EXPECT_FLOAT_EQ(point.at.y, 50.0F);
  EXPECT_NE(strokes.strokes[1].points[20].at, strokes.strokes[2].points[20].at);
}

TEST(StrokeDashes, are_as_long_as_they_say_with_their_round_ends) {
  Curve curve = straight({0, 50}, {100, 50});
  curve.covered = 1;
  StrokeParams params;
  params.hidden = true;
  params.hidden_width = 1.0F;
  const Strokes strokes = strokes_of({curve}, params);  // 6 px and 4 px between them, 2 px wide
  ASSERT_EQ(strokes.strokes.size(), 10U);
  EXPECT_NEAR(strokes.strokes[3].points.front().at.x, 31.0F, 1e-3F);
  EXPECT_NEAR(strokes.strokes[3].points.back().at.x, 35.0F, 1e-3F);
}

TEST(StrokeDashes, know_the_whole_stroke) {
  Curve curve = straight({0, 50}, {100, 50});
  curve.covered = 1;
  StrokeParams params;
  params.hidden = true;
  EXPECT_FLOAT_EQ(strokes_of({curve}, params).strokes.at(4).end_px, 100.0F);
}

}  // namespace
}  // namespace inkbench
