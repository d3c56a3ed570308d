// SPDX-License-Identifier: MIT
// Which frames of a path the grid of a study shows, and where a cell's pictures stand in it.
#include <gmock/gmock.h>

#include "studies/sweep/study_grid.h"

namespace inkbench {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

constexpr const char* kTwoCells = "[[axis]]\nkey = \"combine.k_depth\"\nvalues = [0.001, 0.002]\n";

StudySpec turn(int frames, const std::string& more = "") {
  return parse_spec("size = [100, 80]\n" + more + "[path]\nframes = " + std::to_string(frames) + "\n",
                    "s.toml", {});
}

TEST(PathGrid, rows_show_at_most_eight_frames_at_even_steps) {
  EXPECT_THAT(views_in_grid(turn(5, kTwoCells)), ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(views_in_grid(turn(12, kTwoCells)), ElementsAre(0, 2, 4, 6, 8, 10));
  EXPECT_THAT(views_in_grid(turn(36, kTwoCells)), ElementsAre(0, 5, 10, 15, 20, 25, 30, 35));
}

TEST(PathGrid, a_single_turn_is_a_contact_sheet_of_at_most_thirty_six) {
  EXPECT_THAT(views_in_grid(turn(36)), SizeIs(36));
  EXPECT_THAT(views_in_grid(turn(180)), SizeIs(36));
  EXPECT_EQ(views_in_grid(turn(180))[1], 5U);
}

TEST(PathGrid, frames_are_called_by_their_degrees) {
  EXPECT_EQ(view_label(turn(36), 35), "70°");
  EXPECT_EQ(view_label(parse_spec("[path]\nframes = 7\ndegrees = 90\n", "s.toml", {}), 1), "12.86°");
}

TEST(PathGrid, what_stands_in_it_is_told_by_frame_and_buffer) {
  const StudySpec spec = turn(12, std::string("show = [\"final\", \"depth\"]\n") + kTwoCells);
  EXPECT_TRUE(is_in_grid(spec, 2 * 2 + 1));
  EXPECT_FALSE(is_in_grid(spec, 3 * 2));
  const StudySpec views = parse_spec("[[view]]\nname = \"a\"\n[[view]]\nname = \"b\"\n", "s.toml", {});
  EXPECT_TRUE(is_in_grid(views, 0) && is_in_grid(views, 1)) << "without a path all are";
}

TEST(PathGrid, a_cell_of_it_holds_one_frame_with_its_buffers_side_by_side) {
  const CellLayout one = cell_layout(turn(12, kTwoCells));
  EXPECT_TRUE(one.one_picture);
  EXPECT_EQ(one.width_px, 100);
  const CellLayout two = cell_layout(turn(12, std::string("show = [\"final\", \"depth\"]\n") + kTwoCells));
  EXPECT_EQ(two.pictures, 2U);
  EXPECT_EQ(two.width_px, 204);
  const Picture picture(100, 80, 3);
  EXPECT_EQ(place_of(two, 7, picture).first_px, place_of(two, 1, picture).first_px)
      << "the second buffer of any frame";
  EXPECT_NE(place_of(two, 6, picture).first_px, place_of(two, 7, picture).first_px);
}

}  // namespace
}  // namespace inkbench
