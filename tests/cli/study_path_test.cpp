// SPDX-License-Identifier: MIT
// Studies along a camera path: one row a turn, files by frame, flicker beside recall, and a run that was
// killed ends with the same bytes.
#include <csignal>

#include "pipeline/image/image_file.h"
#include "tests/cli/study_fixture.h"

namespace inkbench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kTurn =
    "size = [160, 120]\nmeasure = [\"flicker\"]\n[path]\nframes = 5\ndegrees = 20\n";

class StudyPath : public StudyTest {
 protected:
  std::string problem(const std::string& body) const {
    write_spec("s", body);
    const CommandResult result = study("s", "out");
    EXPECT_EQ(result.status, 2) << result.out;
    return result.err;
  }
};

TEST_F(StudyPath, a_turn_is_one_row_with_flicker_beside_recall) {
  write_spec("s", std::string(kTurn) + "[[axis]]\nkey = \"combine.k_normal\"\nvalues = [0.003, 0.02]\n");
  ASSERT_TRUE(succeeds(study("s", "out")));
  const StudyTable data = table("out");
  EXPECT_THAT(data.columns,
              ElementsAre("cell", "combine.k_normal", "ink", "ink_px", "recall", "flicker", "error",
                          "FILE_frame_000_final", "FILE_frame_001_final", "FILE_frame_002_final",
                          "FILE_frame_003_final", "FILE_frame_004_final"));
  ASSERT_EQ(data.rows.size(), 2U);
  for (const std::string& flicker : data.column("flicker")) {
    EXPECT_GT(std::stod(flicker), 0);
    EXPECT_LT(std::stod(flicker), 0.5);
  }
  EXPECT_NE(data.column("flicker")[0], data.column("flicker")[1]);
  EXPECT_EQ(data.rows[1].at("FILE_frame_004_final"), "cells/0002_frame_004_final.png");
  EXPECT_NE(content_of(file("out/cells/0001_frame_000_final.png")),
            content_of(file("out/cells/0001_frame_001_final.png")));
  EXPECT_TRUE(succeeds(inkbench({"study", "verify", "out"})));
}

TEST_F(StudyPath, every_frame_carries_its_own_camera) {
  write_spec("s",
             "size = [64, 48]\n[set]\ncamera.eye = [0, 0, 6]\ncamera.target = [0, 0, 0]\n"
             "[path]\nframes = 4\ndegrees = 360\n");
  ASSERT_TRUE(succeeds(study("s", "out")));
  const CommandResult again =
      inkbench({"render", "--from", "out/cells/0001_frame_001_final.png", "--out", "f"});
  ASSERT_TRUE(succeeds(again));
  EXPECT_EQ(read_picture(file("f/final.png"), 3),
            read_picture(file("out/cells/0001_frame_001_final.png"), 3));
  const CommandResult turned = inkbench(
      {"render", "--from", "out/cells/0001_frame_000_final.png", "--set", "camera.eye=6,0,0", "--out", "g"});
  ASSERT_TRUE(succeeds(turned));
  EXPECT_EQ(read_picture(file("g/final.png"), 3),
            read_picture(file("out/cells/0001_frame_001_final.png"), 3));
}

TEST_F(StudyPath, a_still_camera_does_not_flicker) {
  write_spec(
      "s",
      "size = [160, 120]\nmeasure = [\"flicker\", \"flicker_reference\"]\n[path]\nframes = 3\ndegrees = 0\n");
  ASSERT_TRUE(succeeds(study("s", "out")));
  EXPECT_THAT(table("out").column("flicker"), ElementsAre("0"));
  EXPECT_THAT(table("out").column("flicker_reference"), ElementsAre("0"));
}

TEST_F(StudyPath, killed_at_any_moment_it_ends_with_the_same_bytes) {
  write_spec("s", std::string(kTurn) + threshold_axis(6));
  ASSERT_TRUE(succeeds(study("s", "reference")));
  const FolderContent reference = lasting_content(file("reference"));
  const auto pictures =
      static_cast<size_t>(std::distance(fs::directory_iterator(file("reference/cells")), {}));
  int killed = 0, kept = 0;
  for (int point = 1; point <= 3; ++point) {
    const std::string out = "killed_" + std::to_string(point);
    const CommandOptions options = signal_after(file(out), pictures * point / 4, SIGKILL);
    killed += study("s", out, {}, options).signal == SIGKILL ? 1 : 0;
    expect_no_half_written_files(file(out), reference);
    kept += fs::exists(file(out) / "data.csv") && !table(out).rows.empty() ? 1 : 0;
    ASSERT_TRUE(succeeds(study("s", out)));
    EXPECT_EQ(difference(reference, lasting_content(file(out))), "same");
    fs::remove_all(file(out));
  }
  EXPECT_GE(killed, 1) << "some kills came while it ran";
  EXPECT_GE(kept, 1) << "turns that were finished stay";
}

TEST_F(StudyPath, what_a_spec_cannot_say_is_named) {
  EXPECT_THAT(
      problem("measure = [\"flicker\"]\n"),
      HasSubstr("s.toml:3: the measure 'flicker' compares the frames of a path, and there is none; add a "
                "table [path], such as frames = 36"));
  EXPECT_THAT(problem("[path]\n[[view]]\nname = \"front\"\n"),
              HasSubstr("s.toml:4: a [[view]] beside a [path]; leave one of them out"));
  EXPECT_THAT(problem("[path]\nframe = 3\n"),
              HasSubstr("s.toml:4: unknown entry 'frame'; did you mean 'frames'?"));
}

}  // namespace
}  // namespace inkbench
