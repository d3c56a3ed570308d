// SPDX-License-Identifier: MIT
// What a further run of a study keeps, draws again and measures again, and which lines it looks for.
#include <gtest/gtest.h>

#include <chrono>

#include "pipeline/base/files.h"
#include "pipeline/base/log.h"
#include "pipeline/base/text.h"
#include "studies/sweep/run_study.h"
#include "tests/gl/checks.h"

namespace inkbench {
namespace {

constexpr const char* kHead =
    "size = [64, 48]\nshow = [\"normal\", \"combined_edges\"]\n[set]\nmodel.rabbit.shape = \"torus\"\n"
    "[[axis]]\nkey = \"combine.k_normal\"\nvalues = [0.01, 0.05]\n";
const std::string kMeasured = std::string("measure = [\"f1\", \"recall_silhouette\"]\n") + kHead;
const ResultOrigin kOrigin{"drawing 1", "measuring 1", "softpipe"};

class StudyKeys : public testing::Test {
 protected:
  StudyResult run(const std::string& text, const ResultOrigin& origin = kOrigin,
                  const std::vector<std::string>& set = {}) {
    const StudySpec spec = parse_spec(text, folder_.path() / "s.toml", set);
    notes_.clear();
    const LogSink before = set_log_sink([this](const std::string& note) { notes_ += note + "\n"; });
    const long before_runs = pipeline_.counts().at("reference").runs;
    const StudyResult result = run_study(pipeline_, spec, {.folder = out(), .origin = origin});
    searches_ = pipeline_.counts().at("reference").runs - before_runs;
    set_log_sink(before);
    EXPECT_TRUE(result.failures.empty());
    return result;
  }
  /// Runs it again; the times of all pictures tell whether any was written.
  StudyResult resume(const std::string& text, const ResultOrigin& origin = kOrigin,
                     const std::vector<std::string>& set = {}) {
    const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(1);
    for (const auto& file : fs::directory_iterator(out() / "cells")) fs::last_write_time(file, long_ago);
    const StudyResult result = run(text, origin, set);
    pictures_kept_ = 0;
    for (const auto& file : fs::directory_iterator(out() / "cells"))
      pictures_kept_ += fs::last_write_time(file) == long_ago ? 1 : 0;
    return result;
  }
  std::string data() const { return read_file(out() / "data.csv"); }
  fs::path out() const { return folder_.path() / "out"; }

  TempFolder folder_;
  Pipeline pipeline_;
  long searches_ = 0;  ///< For reference lines, in the last run.
  std::string notes_;
  int pictures_kept_ = 0;
};

TEST_F(StudyKeys, no_lines_are_found_that_were_not_asked_for) {
  run(kHead);
  EXPECT_EQ(searches_, 0);
  EXPECT_FALSE(fs::exists(out() / "reference"));
  EXPECT_NE(read_file(out() / "index.html").find("\"overlays\":[]"), std::string::npos);
}

TEST_F(StudyKeys, measures_of_the_drawing_alone_need_no_lines) {
  run(std::string("measure = [\"components\", \"faces\"]\n") + kHead);
  EXPECT_EQ(searches_, 0);
}

TEST_F(StudyKeys, lines_are_found_once_where_they_are_measured_against_or_shown) {
  run(kMeasured);
  EXPECT_EQ(searches_, 1) << "both cells have the same";
  std::string shown = kHead;
  shown.replace(shown.find("\"normal\""), 8, "\"reference\"");
  fs::remove_all(out());
  run(shown);
  EXPECT_EQ(searches_, 1);
  EXPECT_TRUE(fs::exists(out() / "reference"));
}

TEST_F(StudyKeys, the_same_study_keeps_everything) {
  run(kMeasured);
  const StudyResult again = resume(kMeasured);
  EXPECT_EQ(again.progress.drawn + again.progress.measured, 0U);
  EXPECT_EQ(pictures_kept_, 4);
  EXPECT_EQ(notes_, "");
}

TEST_F(StudyKeys, other_sources_that_measure_measure_again_and_write_no_picture) {
  run(kMeasured);
  const std::string before = data();
  const StudyResult again = resume(kMeasured, {"drawing 1", "measuring 2", "softpipe"});
  EXPECT_EQ(again.progress.measured, 2U);
  EXPECT_EQ(again.progress.drawn, 0U);
  EXPECT_EQ(pictures_kept_, 4);
  EXPECT_EQ(data(), before);
  EXPECT_EQ(notes_, "2 cells are measured again: the sources that measure changed\n");
  EXPECT_EQ(resume(kMeasured, {"drawing 1", "measuring 2", "softpipe"}).progress.measured, 0U);
}

TEST_F(StudyKeys, other_measures_are_measured_and_write_no_picture) {
  run(kHead);
  const StudyResult again = resume(kMeasured);
  EXPECT_EQ(again.progress.measured, 2U);
  EXPECT_EQ(pictures_kept_, 4);
  const std::string resumed = data();
  EXPECT_EQ(notes_, "2 cells are measured again: what is measured, or how it is judged, changed\n");
  fs::remove_all(out());
  run(kMeasured);
  EXPECT_EQ(data(), resumed) << "as if it had been measured at once";
}

TEST_F(StudyKeys, another_judge_measures_again_and_writes_no_picture) {
  run(kMeasured);
  const std::string before = data();
  for (const char* set : {"judge.tolerance=0.5", "judge.object=allowed", "judge.crease_angle=5"}) {
    EXPECT_EQ(resume(kMeasured, kOrigin, {set}).progress.measured, 2U) << set;
    EXPECT_EQ(pictures_kept_, 4) << set;
  }
  EXPECT_NE(data(), before);
}

TEST_F(StudyKeys, shown_lines_are_drawn_again_where_the_judge_changes_them) {
  std::string shown = kHead;
  shown.replace(shown.find("\"normal\""), 8, "\"reference\"");
  run(shown);
  EXPECT_EQ(resume(shown, kOrigin, {"judge.tolerance=1"}).progress.drawn, 0U);
  EXPECT_EQ(resume(shown, kOrigin, {"judge.crease_angle=5"}).progress.drawn, 2U);
}

TEST_F(StudyKeys, another_renderer_draws_again_and_both_are_named) {
  run(kMeasured);
  const StudyResult again = resume(kMeasured, {"drawing 1", "measuring 1", "another card"});
  EXPECT_EQ(again.progress.drawn, 2U);
  EXPECT_EQ(pictures_kept_, 0);
  EXPECT_EQ(
      notes_,
      "2 cells are drawn again: they were drawn by another renderer (softpipe; this is another card)\n");
}

TEST_F(StudyKeys, other_sources_that_draw_draw_again) {
  run(kMeasured);
  EXPECT_EQ(resume(kMeasured, {"drawing 2", "measuring 1", "softpipe"}).progress.drawn, 2U);
  EXPECT_EQ(notes_, "2 cells are drawn again: the sources that draw changed\n");
}

TEST_F(StudyKeys, other_settings_draw_again_just_the_cells_that_they_change) {
  run(kMeasured);
  std::string other = kMeasured;
  other.replace(other.find("0.05"), 4, "0.06");
  const StudyResult again = resume(other);
  EXPECT_EQ(again.progress.drawn, 1U);
  EXPECT_EQ(notes_, "1 cell is drawn again: their settings or what they show changed\n");
}

TEST_F(StudyKeys, this_build_says_what_it_is) {
  const ResultOrigin origin = this_origin();
  EXPECT_EQ(origin.drawing_sources.size(), 32U);
  EXPECT_EQ(origin.measuring_sources.size(), 32U);
  EXPECT_NE(origin.drawing_sources, origin.measuring_sources);
  EXPECT_NE(origin.renderer.find("OpenGL"), std::string::npos);
}

}  // namespace
}  // namespace inkbench
