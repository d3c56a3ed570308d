// SPDX-License-Identifier: MIT
// What dies and is born between two frames, counted on maps that are built by hand.
#include "studies/measures/flicker_tally.h"

#include <gtest/gtest.h>

namespace inkbench {
namespace {

constexpr int kWallWidthPx = 60, kWallHeightPx = 40;
constexpr double kWallFar = 10.0, kReachPx = 2.0;

LineMap column_at(int x, int from = 10, int to = 30) {
  LineMap map(kWallWidthPx, kWallHeightPx);
  for (int y = from; y < to; ++y) map.set(x, y);
  return map;
}

LineMap none() {
  return {kWallWidthPx, kWallHeightPx};
}

/// One frame: a wall at some distance, of which every point moves by as much.
struct HandFrame {
  explicit HandFrame(float distance = 5.0F, float right_px = 0.0F)
      : depth(kWallWidthPx, kWallHeightPx, 1, distance / static_cast<float>(kWallFar)),
        motion(kWallWidthPx, kWallHeightPx, 4, 1.0F) {
    for (int y = 0; y < kWallHeightPx; ++y) {
      for (int x = 0; x < kWallWidthPx; ++x) set_motion(x, y, right_px, distance);
    }
  }
  void set_motion(int x, int y, float right_px, float distance_there, bool is_there = true) {
    motion.at(x, y, 0) = is_there ? right_px : 0;
    motion.at(x, y, 1) = 0;
    motion.at(x, y, 2) = is_there ? distance_there : 0;
    motion.at(x, y, 3) = is_there ? 1 : 0;
  }
  /// The columns from `from` to `to` at another distance, moving otherwise; background has distance kWallFar.
  void set_columns(int from, int to, float distance, float right_px) {
    for (int y = 0; y < kWallHeightPx; ++y) {
      for (int x = from; x < to; ++x) {
        depth.at(x, y) = distance / static_cast<float>(kWallFar);
        set_motion(x, y, right_px, distance, distance < kWallFar);
      }
    }
  }
  Image depth, motion;
};

CameraParams wall_camera() {
  CameraParams camera;
  camera.far = static_cast<float>(kWallFar);
  return camera;
}

FlickerCounts count(const HandFrame& before, const LineMap& lines_before, const HandFrame& now,
                    const LineMap& lines_now, double tolerance_px = kReachPx) {
  return LineCarrier({before.depth, wall_camera()}, before.motion, {now.depth, wall_camera()}, now.motion,
                     tolerance_px)
      .counts(lines_before, lines_now);
}

void expect_counts(const FlickerCounts& counts, int64_t died, int64_t born, int64_t carried) {
  EXPECT_EQ(counts.died, died);
  EXPECT_EQ(counts.born, born);
  EXPECT_EQ(counts.carried, carried);
}

TEST(Flicker, lines_that_stay_neither_die_nor_are_born) {
  const FlickerCounts counts = count(HandFrame(), column_at(30), HandFrame(), column_at(30));
  expect_counts(counts, 0, 0, 40);
  EXPECT_EQ(counts.share(), 0.0);
}

TEST(Flicker, a_line_of_one_frame_alone_dies_or_is_born_pixel_by_pixel) {
  expect_counts(count(HandFrame(), column_at(30), HandFrame(), none()), 20, 0, 20);
  expect_counts(count(HandFrame(), none(), HandFrame(), column_at(30)), 0, 20, 20);
  const FlickerCounts both = count(HandFrame(), column_at(20), HandFrame(), column_at(40, 10, 15));
  expect_counts(both, 20, 5, 25);
  EXPECT_EQ(both.share(), 1.0);
}

TEST(Flicker, nothing_carried_has_no_value) {
  EXPECT_EQ(count(HandFrame(), none(), HandFrame(), none()).share(), std::nullopt);
}

TEST(Flicker, lines_that_move_with_their_surface_stay) {
  expect_counts(count(HandFrame(5, 7), column_at(20), HandFrame(5, -7), column_at(27)), 0, 0, 40);
  expect_counts(count(HandFrame(5, 7), column_at(20), HandFrame(5, -7), column_at(20)), 20, 20, 40);
}

TEST(Flicker, a_line_within_the_tolerance_counts_as_the_same_and_one_beyond_it_not) {
  expect_counts(count(HandFrame(), column_at(30), HandFrame(), column_at(32)), 0, 0, 40);
  expect_counts(count(HandFrame(), column_at(30), HandFrame(), column_at(33)), 20, 20, 40);
  expect_counts(count(HandFrame(), column_at(30), HandFrame(), column_at(33), 3), 0, 0, 40);
  expect_counts(count(HandFrame(), column_at(30), HandFrame(), column_at(30), 0), 0, 0, 40);
  // Half a pixel of motion, exactly: 1.5 px to the line from one side, 2.5 from the other.
  expect_counts(count(HandFrame(5, 0.5F), column_at(30), HandFrame(5, 0.5F), column_at(32)), 0, 20, 40);
}

TEST(Flicker, rounding_of_the_motion_decides_nothing) {
  const HandFrame trembling(5, 0.0005F);
  expect_counts(count(trembling, column_at(30), trembling, column_at(30), 0), 0, 0, 40);
  expect_counts(count(trembling, column_at(30), trembling, column_at(32), 2), 0, 0, 40);
}

TEST(Flicker, points_that_are_hidden_in_the_other_frame_do_not_count) {
  HandFrame now;
  now.set_columns(20, 40, 3, 0);  // something nearer came before them
  expect_counts(count(HandFrame(), column_at(30), now, none()), 0, 0, 0);
  // Beside it they are seen.
  expect_counts(count(HandFrame(), column_at(19), now, none()), 20, 0, 20);
}

TEST(Flicker, points_that_leave_the_measured_part_of_the_image_do_not_count) {
  // 2 px of border, and the disc of 2 px in which a line is looked for.
  expect_counts(count(HandFrame(5, -16), column_at(20), HandFrame(), none()), 20, 0, 20);
  expect_counts(count(HandFrame(5, -17), column_at(20), HandFrame(), none()), 0, 0, 0);
  expect_counts(count(HandFrame(5, 100), column_at(20), HandFrame(), none()), 0, 0, 0);
}

TEST(Flicker, a_contour_moves_with_the_nearer_surface) {
  // A pillar that goes 6 px to the right before a wall that stands; the line is drawn on the wall beside it.
  HandFrame before, now;
  before.set_columns(20, 30, 3, 6);
  now.set_columns(26, 36, 3, -6);
  expect_counts(count(before, column_at(30), now, column_at(36)), 0, 0, 40);
  expect_counts(count(before, column_at(31), now, column_at(37)), 0, 0, 40);
  // 3 px away it is the wall's, and behind the pillar later.
  expect_counts(count(before, column_at(32), now, column_at(38)), 0, 20, 20);
}

TEST(Flicker, a_line_on_the_background_belongs_to_the_surface_beside_it_if_there_is_one) {
  HandFrame before(kWallFar), now(kWallFar);
  before.set_columns(0, kWallWidthPx, kWallFar, 0);
  now.set_columns(0, kWallWidthPx, kWallFar, 0);
  expect_counts(count(before, column_at(30), now, none()), 0, 0, 0);
  before.set_columns(20, 30, 3, 6);
  now.set_columns(26, 36, 3, -6);
  expect_counts(count(before, column_at(31), now, none()), 20, 0, 20);
  expect_counts(count(before, column_at(40), now, none()), 0, 0, 0);
}

TEST(Flicker, counts_of_a_path_are_added_before_the_ratio) {
  FlickerTally sum;
  sum.add({.drawn = {.died = 1, .born = 2, .carried = 10}, .wanted = {.died = 0, .born = 1, .carried = 4}});
  sum.add({.drawn = {.died = 3, .born = 0, .carried = 90}, .wanted = {}});
  EXPECT_EQ(sum.drawn.share(), 0.06);
  EXPECT_EQ(sum.wanted.share(), 0.25);
}

}  // namespace
}  // namespace inkbench
