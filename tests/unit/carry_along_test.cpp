// SPDX-License-Identifier: MIT
// Strokes go on from frame to frame with the paint that they had.
#include "pipeline/strokes/carry_along.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/unit/strokes_support.h"

namespace inkbench {
namespace {

Strokes next_strokes(const Strokes& before, std::vector<Curve> curves, StrokeParams params = {}) {
  return make_strokes(curves_of(std::move(curves)), params, default_stroke_classes(), {}, &before);
}

/// Where along its stroke the place is; -1 where it is on none.
float along_of(const Strokes& strokes, uint64_t place) {
  for (const StrokeCourse& course : strokes.courses) {
    for (const PlaceAlong& known : course.places) {
      if (known.place == place) return known.along_px;
    }
  }
  return -1.0F;
}

/// A circle whose point at each 10 degrees lies on place 1000 + degrees; it begins at `from`.
Curve circle_of_places(int from) {
  Curve curve = arc(60.0F, from, from + 360, 36);
  for (size_t i = 0; i < curve.places.size(); ++i)
    curve.places[i] = 1000 + (static_cast<uint64_t>(from) + 10 * i) % 360;
  return curve;
}

TEST(CarryAlong, paint_stays_where_it_was_when_a_line_grows_at_its_start) {
  const Strokes before = strokes_of({straight({50, 50}, {150, 50}, 105)});
  const Strokes now = next_strokes(before, {straight({0, 50}, {150, 50}, 100)});
  EXPECT_FLOAT_EQ(along_of(now, 110), along_of(before, 110));
  EXPECT_EQ(now.strokes[0].number, before.strokes[0].number);
}

TEST(CarryAlong, when_told_not_to_each_frame_begins_anew) {
  StrokeParams params;
  params.coherent = false;
  const Strokes before = strokes_of({straight({50, 50}, {150, 50}, 105)});
  const Strokes now = next_strokes(before, {straight({0, 50}, {150, 50}, 100)}, params);
  EXPECT_FLOAT_EQ(along_of(now, 110), along_of(before, 110) + 50.0F);
}

TEST(CarryAlong, a_line_that_comes_the_other_way_round_is_turned) {
  const Curve curve = straight({0, 50}, {100, 50}, 100);
  Curve turned = curve;
  std::reverse(turned.points.begin(), turned.points.end());
  std::reverse(turned.places.begin(), turned.places.end());
  const Strokes before = strokes_of({curve}), now = next_strokes(before, {turned});
  EXPECT_EQ(now.strokes[0].points.front().at, before.strokes[0].points.front().at);
  EXPECT_FLOAT_EQ(along_of(now, 103), along_of(before, 103));
}

TEST(CarryAlong, a_closed_stroke_begins_where_it_began) {
  const Strokes before = strokes_of({circle_of_places(0)}),
                now = next_strokes(before, {circle_of_places(140)});
  EXPECT_LT(glm::distance(now.strokes[0].points.front().at, before.strokes[0].points.front().at), 0.1F);
  for (uint64_t place = 1000; place < 1360; place += 10)
    EXPECT_NEAR(along_of(now, place), along_of(before, place), 0.05F) << place;
}

TEST(CarryAlong, both_parts_of_a_stroke_that_breaks_keep_its_paint) {
  const Strokes before = strokes_of({straight({0, 50}, {190, 50}, 100)});
  const Strokes now =
      next_strokes(before, {straight({0, 50}, {90, 50}, 100), straight({100, 50}, {190, 50}, 110)});
  EXPECT_FLOAT_EQ(along_of(now, 105), along_of(before, 105));
  EXPECT_FLOAT_EQ(along_of(now, 115), along_of(before, 115));
}

TEST(CarryAlong, a_line_that_shares_nothing_begins_anew) {
  const Strokes before = strokes_of({straight({0, 50}, {100, 50}, 100)});
  const Strokes now = next_strokes(before, {straight({0, 50}, {100, 50}, 300)});
  EXPECT_FLOAT_EQ(now.strokes[0].start_px, 0.0F);
  EXPECT_NE(now.strokes[0].number, before.strokes[0].number);
}

TEST(CarryAlong, the_measured_shift_is_that_of_the_paint) {
  const Strokes before = strokes_of({straight({50, 50}, {150, 50}, 105)});
  const Curve grown = straight({0, 50}, {150, 50}, 100);
  EXPECT_FLOAT_EQ(median_shift_px(carrying_between(before, strokes_of({grown}))), 50.0F);
  EXPECT_FLOAT_EQ(median_shift_px(carrying_between(before, next_strokes(before, {grown}))), 0.0F);
}

TEST(CarryAlong, a_stroke_is_broken_when_it_ends_or_goes_on_in_two) {
  const Strokes before = strokes_of({straight({0, 20}, {190, 20}, 100), straight({0, 50}, {190, 50}, 200),
                                     straight({0, 80}, {190, 80}, 300)});
  const Strokes now = strokes_of({straight({0, 20}, {90, 20}, 100), straight({100, 20}, {190, 20}, 110),
                                  straight({0, 50}, {190, 50}, 200)});
  const StrokeCarrying carrying = carrying_between(before, now);
  EXPECT_EQ(carrying.strokes, 3);
  EXPECT_EQ(carrying.broken, 2);
}

}  // namespace
}  // namespace inkbench
