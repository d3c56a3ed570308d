// SPDX-License-Identifier: MIT
// Strokes as outlines: they cover what the discs along them cover.
#include "pipeline/vectors/stroke_outline.h"

#include <gtest/gtest.h>

#include "pipeline/vectors/fit_path.h"
#include "tests/unit/vector_support.h"

namespace inkbench {
namespace {

constexpr double kPi = std::numbers::pi;

Outline outline_of(const Stroke& stroke) {
  const StrokePart part = whole(stroke);
  return stroke_outline({&part, 1});
}

TEST(StrokeOutline, covers_what_the_discs_cover) {
  const std::vector<Stroke> strokes{
      loop_stroke(),
      ring_stroke({60, 60}, 25),
      stroke_through({{{10, 10}, 0.3F}, {{90, 14}, 0.3F}}),
      stroke_through({{{10, 90}, 6.0F}, {{12, 88}, 1.0F}, {{60, 92}, 2.5F}, {{20, 80}, 0.0F}}),
  };
  for (const Stroke& stroke : strokes) {
    const Outline outline = outline_of(stroke);
    const Image wanted = disc_coverage({stroke}, 100, 100);
    EXPECT_LE(coverage_rms(ring_coverage(outline, 100, 100), wanted), 0.003);
    std::vector<Ring> fitted;
    for (const CubicPath& path : fit_outline(outline, {.error = 0.05, .corner_reach = 0.15}))
      fitted.push_back(flattened(path));
    EXPECT_LE(coverage_rms(ring_coverage(fitted, 100, 100), wanted), 0.02);
  }
}

TEST(StrokeOutline, straight_stroke_has_the_area_of_a_capsule) {
  const Outline outline = outline_of(stroke_through({{{10, 10}, 3.0F}, {{25, 10}, 3.0F}, {{40, 10}, 3.0F}}));
  ASSERT_EQ(outline.size(), 1U);
  EXPECT_NEAR(area(outline), 30.0 * 6.0 + kPi * 9.0, 0.15);
}

TEST(StrokeOutline, closed_stroke_leaves_its_middle_open) {
  const Outline outline = outline_of(ring_stroke({50, 50}, 20));
  EXPECT_EQ(outline.size(), 2U);
  EXPECT_LT(area(outline), kPi * 20.0 * 20.0 * 0.5);
}

TEST(StrokeOutline, disc_within_the_next_one_adds_nothing) {
  const Outline outline = outline_of(stroke_through({{{10, 10}, 1.0F}, {{11, 10}, 5.0F}}));
  EXPECT_NEAR(area(outline), kPi * 25.0, 0.25);
}

TEST(StrokeOutline, strokes_that_cross_cover_the_crossing_once) {
  const Stroke one = stroke_through({{{10, 50}, 2.0F}, {{90, 50}, 2.0F}});
  const Stroke other = stroke_through({{{50, 10}, 2.0F}, {{50, 90}, 2.0F}});
  const std::vector<StrokePart> parts{whole(one), whole(other)};
  const Outline outline = stroke_outline(parts);
  EXPECT_EQ(outline.size(), 1U);
  EXPECT_NEAR(area(outline), 2.0 * (80.0 * 4.0 + kPi * 4.0) - 16.0, 0.3);
}

TEST(StrokeOutline, part_of_a_stroke_ends_round) {
  const Stroke stroke = stroke_through({{{10, 10}, 2.0F}, {{20, 10}, 2.0F}, {{30, 10}, 2.0F}});
  const StrokePart part{&stroke, 0, 1};
  EXPECT_NEAR(area(stroke_outline({&part, 1})), 10.0 * 4.0 + kPi * 4.0, 0.1);
}

TEST(StrokeOutline, stroke_without_width_covers_nothing) {
  EXPECT_TRUE(outline_of(stroke_through({{{10, 10}, 0.0F}, {{20, 10}, 0.0F}})).empty());
}

TEST(StrokeOutline, shape_without_another_keeps_the_rest) {
  const Ring square{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, middle{{4, 4}, {6, 4}, {6, 6}, {4, 6}};
  const Outline rest = without({square}, {middle});
  EXPECT_EQ(rest.size(), 2U);
  EXPECT_NEAR(area(rest), 96.0, 1e-6);
}

}  // namespace
}  // namespace inkbench
