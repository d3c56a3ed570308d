// SPDX-License-Identifier: MIT
// How wide strokes are, and what their width follows.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/strokes_support.h"
#include "tests/unit/support.h"

namespace inkbench {
namespace {

const Curve kLine = straight({0, 50}, {100, 50});

std::vector<StrokePoint> points_of(const Curve& curve, const StrokeParams& params,
                                   const StrokeSurroundings& around = {}) {
  return strokes_of({curve}, params, around).strokes.at(0).points;
}

/// The width where the stroke is so long.
float width_at(const std::vector<StrokePoint>& points, float along_px) {
  const auto nearest = std::min_element(points.begin(), points.end(), [&](const auto& a, const auto& b) {
    return std::abs(a.along_px - along_px) < std::abs(b.along_px - along_px);
  });
  return 2.0F * nearest->radius_px;
}

TEST(StrokeWidth, is_what_the_style_says_in_pixels) {
  StrokeParams params;
  params.width = 5.0F;
  EXPECT_FLOAT_EQ(width_at(points_of(kLine, params), 50.0F), 5.0F);
}

TEST(StrokeWidth, in_percent_is_of_the_images_height) {
  StrokeParams params;
  params.width = 2.0F;
  params.unit = WidthUnit::percent;
  EXPECT_FLOAT_EQ(width_at(points_of(kLine, params, {.height_px = 400}), 50.0F), 8.0F);
}

TEST(StrokeWidth, in_world_units_gets_thinner_with_distance) {
  Curve curve = kLine;
  curve.depths.assign(curve.depths.size(), 4.0F);
  StrokeParams params;
  params.width = 0.1F;
  params.unit = WidthUnit::world;
  EXPECT_FLOAT_EQ(width_at(points_of(curve, params, {.pixel_size = 0.01F}), 50.0F), 2.5F);
}

TEST(StrokeWidth, outlines_are_as_much_wider_as_asked_for) {
  Curve curve = kLine;
  curve.behind = Behind::nothing;
  StrokeParams params;
  params.outline = 3.0F;
  EXPECT_FLOAT_EQ(width_at(points_of(curve, params), 50.0F), 6.0F);
  EXPECT_FLOAT_EQ(width_at(points_of(kLine, params), 50.0F), 2.0F);
}

TEST(StrokeWidth, the_farthest_are_thinner_by_depth_taper) {
  Curve curve = kLine;
  curve.depths.assign(curve.depths.size(), 3.0F);
  StrokeParams params;
  params.depth_taper = 0.6F;
  EXPECT_NEAR(width_at(points_of(curve, params, {.visible = {1.0F, 3.0F}}), 50.0F), 0.8F, 1e-5F);
  EXPECT_NEAR(width_at(points_of(curve, params, {.visible = {1.0F, 5.0F}}), 50.0F), 1.4F, 1e-5F);
}

TEST(StrokeWidth, goes_over_from_class_to_class_without_a_step) {
  Curve first = straight({0, 50}, {50, 50}), second = straight({50, 50}, {100, 50});
  second.curve_class = CurveClass::crease;
  first.chain = second.chain = 3;
  first.end = second.start = CurveEnd::other_class;
  StrokeClasses classes = default_stroke_classes();
  classes[static_cast<size_t>(CurveClass::crease)].width = 3.0F;
  const auto points = make_strokes(curves_of({first, second}), {}, classes, {}).strokes.at(0).points;
  EXPECT_FLOAT_EQ(width_at(points, 30.0F), 2.0F);
  EXPECT_FLOAT_EQ(width_at(points, 50.0F), 4.0F);
  EXPECT_FLOAT_EQ(width_at(points, 70.0F), 6.0F);
}

TEST(StrokeWidth, tapers_from_the_tip_to_all_of_it) {
  StrokeParams params;
  params.taper_in = 20.0F;
  params.taper_out = 30.0F;
  params.tip = 0.25F;
  const auto points = points_of(kLine, params);
  EXPECT_FLOAT_EQ(2.0F * points.front().radius_px, 0.5F);
  EXPECT_FLOAT_EQ(width_at(points, 40.0F), 2.0F);
  EXPECT_FLOAT_EQ(2.0F * points.back().radius_px, 0.5F);
  EXPECT_LT(width_at(points, 80.0F), 2.0F);
}

TEST(StrokeWidth, two_tapers_that_do_not_fit_meet_in_their_proportion) {
  StrokeParams params;
  params.taper_in = 100.0F;
  params.taper_out = 300.0F;
  const auto points = points_of(kLine, params);
  const auto widest = std::max_element(
      points.begin(), points.end(), [](const auto& a, const auto& b) { return a.radius_px < b.radius_px; });
  EXPECT_NEAR(widest->along_px, 25.0F, 3.0F);
  EXPECT_NEAR(widest->radius_px, 1.0F, 0.05F);
}

TEST(StrokeWidth, closed_strokes_have_no_ends_to_taper) {
  StrokeParams params;
  params.taper_in = params.taper_out = 20.0F;
  for (const StrokePoint& point : points_of(arc(50.0F, 0, 360), params))
    EXPECT_FLOAT_EQ(point.radius_px, 1.0F);
}

TEST(StrokeWidth, follows_the_profile) {
  StrokeParams params;
  params.profile = "0 0.2, 0.5 1, 1 0";
  const auto points = points_of(kLine, params);
  EXPECT_FLOAT_EQ(2.0F * points.front().radius_px, 0.4F);
  EXPECT_NEAR(width_at(points, 50.0F), 2.0F, 0.05F);
  EXPECT_NEAR(width_at(points, 75.0F), 1.0F, 0.05F);
}

TEST(StrokeWidth, a_bend_of_ten_widths_is_twice_as_thick) {
  StrokeParams params;
  params.curvature_width = 1.0F;
  EXPECT_NEAR(width_at(points_of(arc(20.0F, 0, 360), params), 60.0F), 4.0F, 0.1F);
  EXPECT_NEAR(width_at(points_of(arc(80.0F, 0, 360), params), 60.0F), 2.5F, 0.1F);
  EXPECT_FLOAT_EQ(width_at(points_of(kLine, params), 50.0F), 2.0F);
}

/// Black on the left half, white on the right one.
Image half_dark() {
  Image image(200, 200, 1);
  for (int y = 0; y < 200; ++y)
    for (int x = 50; x < 200; ++x) image.at(x, y) = 1.0F;
  return image;
}

TEST(StrokeWidth, is_thicker_in_the_dark) {
  const Image luminance = half_dark();
  StrokeParams params;
  params.shadow_width = 1.0F;
  const auto points = points_of(kLine, params, {.luminance = &luminance});
  EXPECT_NEAR(width_at(points, 15.0F), 4.0F, 0.01F);
  EXPECT_NEAR(width_at(points, 50.0F), 3.0F, 0.2F);
  EXPECT_NEAR(width_at(points, 85.0F), 2.0F, 0.01F);
}

TEST(StrokeWidth, the_light_is_that_of_the_strokes_own_object) {
  Image luminance(200, 200, 1, 1.0F), ids(200, 200, 1);
  for (int y = 50; y < 200; ++y)
    for (int x = 0; x < 200; ++x) {
      luminance.at(x, y) = 0.0F;
      ids.at(x, y) = 1.0F;
    }
  StrokeParams params;
  params.shadow_width = 1.0F;
  EXPECT_NEAR(width_at(points_of(kLine, params, {.luminance = &luminance, .object_id = &ids}), 50.0F), 4.0F,
              0.01F);
}

TEST(StrokeWidth, a_stroke_that_has_none_is_left_out) {
  StrokeParams params;
  params.hidden = true;
  params.hidden_width = 0.0F;
  Curve curve = kLine;
  curve.covered = 1;
  EXPECT_TRUE(strokes_of({curve}, params).strokes.empty());
}

TEST(StrokeWidth, a_wrong_profile_is_an_error_that_names_it) {
  StrokeParams params;
  params.profile = "0 0.2, 0.5";
  EXPECT_NE(error_of([&] { strokes_of({kLine}, params); }).find("stroke.profile"), std::string::npos);
}

}  // namespace
}  // namespace inkbench
