// SPDX-License-Identifier: MIT
// A stroke's width along its course, edited by hand.
#include "app/workbench/profile_edit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/workbench/sample_stroke.h"
#include "pipeline/base/error.h"

namespace inkbench {
namespace {

std::string edited(const WidthProfile& profile) {
  return profile_text(profile);
}

WidthProfile profile_of(const char* text) {
  return parse_profile(text, "test");
}

TEST(ProfileEdit, added_point_comes_in_order_and_takes_the_place_of_one_there) {
  const WidthProfile profile = profile_of("0 1, 1 0.5");
  EXPECT_EQ(edited(with_point(profile, {0.5F, 0.2F})), "0 1, 0.5 0.2, 1 0.5");
  EXPECT_EQ(edited(with_point(profile, {1.2F, 0.2F})), "0 1, 1 0.2");
}

TEST(ProfileEdit, moved_point_stays_between_its_neighbours) {
  const WidthProfile profile = profile_of("0 1, 0.5 1, 0.7 1");
  EXPECT_EQ(edited(move_point(profile, 1, {0.9F, 1.4F})), "0 1, 0.7 1, 0.7 1");
  EXPECT_EQ(edited(move_point(profile, 2, {0.1F, -1.0F})), "0 1, 0.5 1, 0.5 0");
}

TEST(ProfileEdit, removing_the_only_point_leaves_the_whole_width) {
  EXPECT_EQ(edited(remove_point(profile_of("0.3 0.5"), 0)), "");
}

TEST(ProfileEdit, straight_line_drawn_by_hand_has_two_points) {
  WidthProfile drawn;
  for (int i = 0; i <= 200; ++i) drawn.push_back({0.005F * i, 0.2F + 0.003F * i + (i % 2) * 0.01F});
  EXPECT_EQ(drawn_over({}, drawn, 0.02F).size(), 2U);
}

TEST(ProfileEdit, drawn_bow_is_kept_within_the_tolerance) {
  WidthProfile drawn;
  for (int i = 0; i <= 200; ++i) drawn.push_back({0.005F * i, std::sin(0.005F * 3.14159F * i)});
  const WidthProfile profile = drawn_over({}, drawn, 0.02F);
  EXPECT_LT(profile.size(), 20U);
  for (const ProfilePoint& point : drawn)
    EXPECT_NEAR(share_of(profile, point.along), point.share, 0.021F) << point.along;
}

TEST(ProfileEdit, what_was_not_drawn_over_stays) {
  const WidthProfile profile = profile_of("0 0, 1 1");
  const WidthProfile next = drawn_over(profile, WidthProfile{{0.4F, 0.9F}, {0.6F, 0.9F}}, 0.02F);
  EXPECT_EQ(edited(next), "0 0, 0.38 0.38, 0.4 0.9, 0.6 0.9, 0.62 0.62, 1 1");
}

TEST(ProfileEdit, hand_that_goes_back_draws_over_what_it_drew) {
  const WidthProfile drawn{{0.0F, 0.5F}, {1.0F, 0.5F}, {0.5F, 0.1F}};
  const WidthProfile next = drawn_over({}, drawn, 0.02F);
  EXPECT_FLOAT_EQ(share_of(next, 0.5F), 0.1F);
  EXPECT_FLOAT_EQ(share_of(next, 0.0F), 0.5F);
}

TEST(ProfileEdit, mere_touch_changes_nothing) {
  const WidthProfile profile = profile_of("0 0, 1 1");
  EXPECT_EQ(edited(drawn_over(profile, WidthProfile{{0.4F, 0.9F}}, 0.02F)), edited(profile));
}

TEST(ProfileEdit, result_is_what_settings_take) {
  WidthProfile drawn;
  for (int i = 0; i <= 50; ++i) drawn.push_back({0.02F * (i * 7 % 50), 0.02F * (i * 13 % 50)});
  EXPECT_NO_THROW(parse_profile(profile_text(drawn_over(profile_of("0 0.2, 0.5 1"), drawn, 0.02F)), "test"));
}

TEST(SampleStroke, has_the_profiles_widths) {
  Settings settings;
  settings.stroke.width = 10;
  settings.stroke.profile = "0 0, 1 1";
  const Strokes strokes = sample_stroke(settings, 200, 60);
  ASSERT_EQ(strokes.strokes.size(), 1U);
  const std::vector<StrokePoint>& points = strokes.strokes[0].points;
  EXPECT_NEAR(points.front().radius_px, 0, 0.2);
  EXPECT_NEAR(points[points.size() / 2].radius_px, 2.5, 0.4);
  EXPECT_NEAR(points.back().radius_px, 5, 0.2);
}

}  // namespace
}  // namespace inkbench
