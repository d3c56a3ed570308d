// SPDX-License-Identifier: MIT
// A study that was stopped, killed or tampered with continues where it stands and ends with the same bytes.
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include <nlohmann/json.hpp>

#include "pipeline/image/image_file.h"
#include "tests/cli/study_fixture.h"

namespace inkbench {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr int kCells = 30;
constexpr int kKillPoints = 15;

class StudyResume : public StudyTest {
 protected:
  StudyResume() {
    write_spec("s", "size = [160, 120]\nshow = [\"final\", \"normal_edges\"]\n" + threshold_axis(kCells));
  }

  /// The finished study, and how long it took.
  void make_reference() {
    const CommandResult result = study("s", "reference");
    ASSERT_TRUE(succeeds(result));
    seconds_ = result.seconds;
    reference_ = lasting_content(file("reference"));
  }

  std::string difference_to_reference(const std::string& out) const {
    return difference(reference_, lasting_content(file(out)));
  }

  /// Runs it to the end in a folder; returns how many cells this run drew.
  int finish(const std::string& out, const std::vector<std::string>& more = {}) const {
    EXPECT_TRUE(succeeds(study("s", out, more)));
    EXPECT_EQ(difference_to_reference(out), "same");
    return nlohmann::json::parse(content_of(file(out) / "manifest.json")).at("times").at("cells_drawn");
  }

  /// How many pictures the last run in a folder decoded for its grid and page.
  int decoded(const std::string& out) const {
    return nlohmann::json::parse(content_of(file(out) / "manifest.json")).at("times").at("pictures_decoded");
  }

  std::vector<fs::path> tiles(const std::string& out) const {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(file(out) / "tiles")) paths.push_back(entry.path());
    return paths;
  }

  double seconds_ = 0;
  FolderContent reference_;
};

TEST_F(StudyResume, finished_study_draws_nothing_again) {
  make_reference();
  const CommandResult again = study("s", "reference");
  ASSERT_TRUE(succeeds(again));
  EXPECT_EQ(again.err, "30 / 30 cells\n");
  EXPECT_EQ(difference_to_reference("reference"), "same");
  EXPECT_EQ(finish("reference"), 0);
}

TEST_F(StudyResume, interrupt_stops_cleanly_and_the_next_run_continues) {
  make_reference();
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string out = "out" + std::to_string(signal);
    const CommandResult stopped = study("s", out, {}, signal_after(file(out), 6, signal));
    EXPECT_EQ(stopped.status, 1) << stopped.err;
    EXPECT_EQ(stopped.signal, 0) << "it ends by itself";
    EXPECT_THAT(stopped.err, HasSubstr("stopped after "));
    EXPECT_THAT(stopped.err, HasSubstr("the same command continues"));
    EXPECT_THAT(unfinished_files(file(out)), IsEmpty());
    expect_no_half_written_files(file(out), reference_);
    EXPECT_EQ(nlohmann::json::parse(content_of(file(out) / "manifest.json")).at("state"), "stopped");
    const size_t done = table(out).rows.size();
    EXPECT_GE(done, 3U);
    EXPECT_EQ(finish(out), kCells - static_cast<int>(done)) << "only what was left";
  }
}

TEST_F(StudyResume, killed_at_any_moment_it_ends_with_the_same_bytes) {
  make_reference();
  int killed = 0;
  for (int point = 1; point <= kKillPoints; ++point) {
    const std::string out = "killed_" + std::to_string(point);
    // By the clock at every other point, which reaches what is before and after the pictures, too.
    CommandOptions by_clock;
    by_clock.signal_when = [&](double seconds) {
      return seconds >= seconds_ * point / kKillPoints ? SIGKILL : 0;
    };
    const size_t pictures = 2 * kCells * static_cast<size_t>(point) / (kKillPoints + 5);
    const CommandOptions options = point % 2 == 0 ? by_clock : signal_after(file(out), pictures, SIGKILL);
    killed += study("s", out, {}, options).signal == SIGKILL && point % 2 != 0 ? 1 : 0;
    expect_no_half_written_files(file(out), reference_);
    finish(out);
    fs::remove_all(file(out));
  }
  EXPECT_GE(killed, 3) << "kills came while it ran";
}

TEST_F(StudyResume, killed_again_and_again_it_still_moves_on) {
  make_reference();
  int runs = 0;
  for (size_t cells = 2; runs < 60; ++runs) {
    // Each run dies when two more pictures are there than at the last death, however far the encoders had
    // got.
    const CommandResult result = study("s", "out", {}, signal_after(file("out"), cells, SIGKILL));
    if (result.signal != SIGKILL) break;
    expect_no_half_written_files(file("out"), reference_);
    size_t present = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(file("out/cells"))) ++present;
    cells = present + 12;
  }
  EXPECT_LT(runs, 60);
  EXPECT_EQ(difference_to_reference("out"), "same");
}

TEST_F(StudyResume, damaged_or_missing_cells_are_made_again) {
  make_reference();
  fs::copy(file("reference"), file("out"), fs::copy_options::recursive);
  const fs::path cells = file("out/cells");
  fs::resize_file(cells / "0002_final.png", fs::file_size(cells / "0002_final.png") / 2);
  fs::remove(cells / "0005_normal_edges.png");
  std::string content = content_of(cells / "0007_final.png");
  content[content.size() / 2] = static_cast<char>(content[content.size() / 2] + 1);
  std::ofstream(cells / "0007_final.png", std::ios::binary) << content;  // same size, other bytes
  std::ofstream(cells / "0009_final.png", std::ios::trunc).close();
  EXPECT_EQ(finish("out"), 4);
}

TEST_F(StudyResume, grid_and_page_decode_no_picture_in_any_run) {
  make_reference();
  EXPECT_EQ(decoded("reference"), 0);
  fs::remove(file("reference/grid.png"));
  EXPECT_EQ(finish("reference"), 0);
  EXPECT_EQ(decoded("reference"), 0);
}

TEST_F(StudyResume, grid_and_page_decode_the_pictures_whose_tiles_are_damaged_or_missing) {
  make_reference();
  fs::copy(file("reference"), file("out"), fs::copy_options::recursive);
  const std::vector<fs::path> paths = tiles("out");
  ASSERT_EQ(paths.size(), 2U * kCells);
  fs::remove(paths[0]);
  fs::resize_file(paths[1], fs::file_size(paths[1]) - 1);
  std::ofstream(paths[2], std::ios::trunc).close();
  std::string content = content_of(paths[3]);
  content[content.size() / 2] = static_cast<char>(content[content.size() / 2] + 1);
  std::ofstream(paths[3], std::ios::binary) << content;
  std::ofstream(paths[4], std::ios::binary) << content_of(file("out/cells/0001_final.png"));
  EXPECT_EQ(finish("out"), 0);
  EXPECT_EQ(decoded("out"), 5);
}

TEST_F(StudyResume, tiles_that_cannot_be_kept_cost_decoding_alone) {
  make_reference();
  write("out/tiles", "no folder");
  ASSERT_TRUE(succeeds(study("s", "out")));
  EXPECT_EQ(decoded("out"), 2 * kCells);
  EXPECT_TRUE(lasting_content(file("out")).at("grid.png") == reference_.at("grid.png"));
  EXPECT_EQ(content_of(file("out/index.html")), reference_.at("index.html"));
}

TEST_F(StudyResume, another_size_in_the_grid_decodes_each_picture_once_and_leaves_no_old_tiles) {
  ASSERT_TRUE(succeeds(study("s", "out")));
  write_spec("s", "grid_px = 100\nsize = [160, 120]\nshow = [\"final\", \"normal_edges\"]\n" +
                      threshold_axis(kCells));
  make_reference();
  EXPECT_EQ(finish("out"), 0);
  EXPECT_EQ(decoded("out"), 2 * kCells);
}

TEST_F(StudyResume, damaged_grid_table_or_manifest_is_made_again) {
  make_reference();
  fs::copy(file("reference"), file("out"), fs::copy_options::recursive);
  write("out/grid.png", "broken");
  write("out/data.csv", "broken");
  write("out/manifest.json", "{");
  EXPECT_EQ(finish("out"), 0);
}

TEST_F(StudyResume, torn_journal_line_costs_its_cell_alone) {
  make_reference();
  fs::copy(file("reference"), file("out"), fs::copy_options::recursive);
  const fs::path journal = file("out/journal.jsonl");
  fs::resize_file(journal, fs::file_size(journal) - 20);
  EXPECT_EQ(finish("out"), 1);
}

TEST_F(StudyResume, journal_of_garbage_is_not_trusted) {
  make_reference();
  const std::vector<std::string> garbage{
      "",
      "\n\n\n",
      std::string("\0\xff\xfe{}[", 7),
      "[]\n{}\nnull\n3\n",
      "{\"cell\": -1, \"key\": 3}\n{\"cell\": 999999999, \"key\": \"x\", \"numbers\": [], \"files\": []}\n",
      "{\"cell\": 0, \"key\": \"x\", \"numbers\": [\"1\", \"2\"], \"files\": [{\"name\": "
      "\"../../etc/passwd\", "
      "\"bytes\": 1, \"hash\": \"x\"}]}\n"};
  for (const std::string& text : garbage) {
    fs::remove_all(file("out"));
    fs::copy(file("reference"), file("out"), fs::copy_options::recursive);
    write("out/journal.jsonl", text);
    EXPECT_EQ(finish("out"), kCells) << text;
  }
}

TEST_F(StudyResume, changed_scene_makes_the_cells_again) {
  ASSERT_TRUE(succeeds(study("s", "out")));
  write("scene.toml", small_scene() + "[ink]\ncolour = \"#800000\"\n");
  make_reference();
  EXPECT_EQ(finish("out"), kCells);
}

TEST_F(StudyResume, longer_axis_keeps_the_cells_that_are_still_the_same) {
  write_spec("s", "[[axis]]\nkey = \"camera.fov\"\nvalues = [30, 40]\n");
  ASSERT_TRUE(succeeds(study("s", "out")));
  write_spec("s", "[[axis]]\nkey = \"camera.fov\"\nvalues = [30, 40, 50]\n");
  make_reference();
  EXPECT_EQ(finish("out"), 1);
}

TEST_F(StudyResume, shorter_axis_leaves_no_cells_of_the_longer_one) {
  write_spec("s",
             "[[axis]]\nkey = \"camera.fov\"\nvalues = [30, 40, 50]\n[[axis]]\nkey = "
             "\"camera.eye.x\"\nvalues = [0, 1]\n"
             "[[axis]]\nkey = \"camera.eye.y\"\nvalues = [1, 2]\n");
  ASSERT_TRUE(succeeds(study("s", "out")));
  write_spec("s", "[[axis]]\nkey = \"camera.fov\"\nvalues = [30, 40]\n");
  make_reference();
  EXPECT_EQ(finish("out"), 0) << "the first row's first two cells are the same";
}

TEST_F(StudyResume, fresh_draws_everything_again) {
  make_reference();
  fs::copy(file("reference"), file("out"), fs::copy_options::recursive);
  EXPECT_EQ(finish("out", {"--fresh"}), kCells);
}

TEST_F(StudyResume, other_files_in_the_folder_are_left_alone) {
  make_reference();
  write("out/my notes.txt", "mine");
  write("out/cells/0001_final.png", "not a picture");
  write("out/cells/sketch.png", "mine too");
  EXPECT_TRUE(succeeds(study("s", "out", {"--fresh"})));
  EXPECT_EQ(content_of(file("out/my notes.txt")), "mine");
  EXPECT_EQ(content_of(file("out/cells/sketch.png")), "mine too");
  EXPECT_EQ(read_picture(file("out/cells/0001_final.png"), 3).width_px, 160);
}

TEST_F(StudyResume, second_run_in_the_same_folder_is_turned_away_while_the_first_one_runs) {
  write_spec("study", threshold_axis(2));
  fs::create_directories(file("out"));
  const int held = open(file("out").c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(flock(held, LOCK_EX | LOCK_NB), 0);
  const CommandResult refused = study("study", "out");
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("another run is writing to this folder"));
  close(held);
  EXPECT_EQ(study("study", "out").status, 0);
}

}  // namespace
}  // namespace inkbench
