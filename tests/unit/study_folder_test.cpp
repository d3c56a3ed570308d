// SPDX-License-Identifier: MIT
// A study's folder: what is kept of an earlier run, and how data.csv grows.
#include "studies/sweep/study_folder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <functional>

#include <optional>
#include <thread>

#include "pipeline/base/files.h"
#include "pipeline/base/text.h"
#include "tests/unit/support.h"

namespace inkbench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr const char* kTwoByTwo =
    "show = [\"final\", \"depth\"]\n"
    "[[axis]]\nkey = \"combine.k_depth\"\nvalues = [0.25, 0.5]\n"
    "[[axis]]\nkey = \"model.rabbit.mesh\"\nvalues = [\"rabbit\", \"a, \\\"b\\\".obj\"]\n";

/// `drawing` and `measuring` stand for all that decides the pictures and the numbers.
std::vector<CellKeys> keys_of(size_t count, const std::string& drawing = "",
                              const std::string& measuring = "") {
  std::vector<CellKeys> keys;
  for (size_t i = 0; i < count; ++i) {
    const Key pictures = KeyBuilder().add(drawing).add(std::to_string(i)).key();
    keys.push_back({pictures, KeyBuilder().add(pictures).add(measuring).key()});
  }
  return keys;
}

const ResultOrigin kOrigin{"drawing 1", "measuring 1", "softpipe"};

class StudyFolderTest : public ::testing::Test {
 protected:
  StudyFolder open(bool fresh = false, const std::string& drawing = "", const std::string& measuring = "",
                   const ResultOrigin& origin = kOrigin) {
    return {spec_, folder_.path(), keys_of(cell_count(spec_), drawing, measuring), origin, fresh};
  }
  void finish_cell(StudyFolder& study, size_t index) {
    std::vector<std::string> overlays;
    for (size_t view = 0; view < view_count(spec_); ++view) {
      for (const BufferName buffer : spec_.show)
        folder_.write(study.cell_file(index, view, buffer), "picture " + std::to_string(index));
      if (!finds_lines(spec_)) continue;
      overlays.push_back(fmt::format("reference/{:016x}.svg", index));
      folder_.write(overlays.back(), "lines");
    }
    std::vector<std::string> numbers{"0.5", std::to_string(100 + index)};
    numbers.resize(2 + spec_.measures.size(), "0.25");
    study.add(index, numbers, overlays);
  }
  std::string data() const { return read_file(folder_.path() / "data.csv"); }
  /// As if a run had written it so.
  void change_record(size_t index, const std::function<void(CellRecord&)>& change) const {
    Journal read = read_journal(folder_.path() / "journal.jsonl");
    change(read.cells.at(index));
    std::string text;
    for (const auto& [cell, record] : read.cells) text += journal_line(record);
    folder_.write("journal.jsonl", text);
  }
  std::string journal() const { return read_file(folder_.path() / "journal.jsonl"); }

  const TemporaryFolder folder_;
  StudySpec spec_ = parse_spec(kTwoByTwo, "/studies/s.toml", {});
};

TEST_F(StudyFolderTest, starts_with_a_header_in_the_agreed_order) {
  const StudyFolder study = open();
  EXPECT_EQ(data(), "cell,combine.k_depth,model.rabbit.mesh,ink,ink_px,error,FILE_final,FILE_depth\n");
  EXPECT_EQ(journal(), "");
  EXPECT_EQ(study.done_count(), 0U);
}

TEST_F(StudyFolderTest, variants_have_a_column_of_names_and_one_for_each_key_that_any_sets) {
  spec_ = parse_spec(
      "[[variant]]\nname = \"a, b\"\n[variant.set]\ncombine.k_depth = 0.5\n"
      "[[variant]]\nname = \"c\"\n[variant.set]\ncombine.threshold = 1\ncombine.k_depth = 0.25\ncamera.eye.x "
      "= 7\n",
      "/studies/s.toml", {});
  StudyFolder study = open();
  finish_cell(study, 0);
  finish_cell(study, 1);
  EXPECT_EQ(data(),
            "cell,variant,combine.k_depth,combine.threshold,camera.eye.x,ink,ink_px,error,FILE_final\n"
            "1,\"a, b\",0.5,0.75,2.4,0.5,100,,cells/0001_final.png\n"
            "2,c,0.25,1,7,0.5,101,,cells/0002_final.png\n");
}

TEST_F(StudyFolderTest, rows_come_as_cells_end_and_awkward_values_are_quoted) {
  StudyFolder study = open();
  finish_cell(study, 2);
  finish_cell(study, 0);
  EXPECT_EQ(data(),
            "cell,combine.k_depth,model.rabbit.mesh,ink,ink_px,error,FILE_final,FILE_depth\n"
            "3,0.25,\"a, \"\"b\"\".obj\",0.5,102,,cells/0003_final.png,cells/0003_depth.png\n"
            "1,0.25,rabbit,0.5,100,,cells/0001_final.png,cells/0001_depth.png\n");
  EXPECT_TRUE(study.is_done(0));
  EXPECT_FALSE(study.is_done(1));
  EXPECT_EQ(study.done_count(), 2U);
}

TEST_F(StudyFolderTest, finish_sorts_by_cell_whatever_the_order_was) {
  {
    StudyFolder study = open();
    for (const size_t index : {3U, 1U, 0U, 2U}) finish_cell(study, index);
    study.finish();
  }
  const std::string data_backwards = data();
  const std::string journal_backwards = journal();
  StudyFolder study = open(true);
  for (const size_t index : {0U, 1U, 2U, 3U}) finish_cell(study, index);
  EXPECT_EQ(data(), data_backwards) << "in order from the start";
  EXPECT_EQ(journal(), journal_backwards);
  study.finish();
  EXPECT_EQ(data(), data_backwards);
}

TEST_F(StudyFolderTest, failures_are_listed_with_their_error_and_no_files) {
  StudyFolder study = open();
  finish_cell(study, 1);
  study.add_failure(0, "cannot be \"drawn\", sorry");
  EXPECT_THAT(data(), HasSubstr("\n1,0.25,rabbit,,,\"cannot be \"\"drawn\"\", sorry\",,\n"));
  EXPECT_FALSE(study.is_done(0));
  study.finish();
  EXPECT_THAT(data(), HasSubstr("FILE_depth\n1,0.25,rabbit,,,\"cannot"));
  EXPECT_THAT(data(), HasSubstr(",,\n2,0.5,rabbit,0.5,101,"));
}

TEST_F(StudyFolderTest, a_later_run_tries_failed_cells_again) {
  {
    StudyFolder study = open();
    study.add_failure(0, "no");
    study.finish();
  }
  const StudyFolder study = open();
  EXPECT_FALSE(study.is_done(0));
  EXPECT_THAT(data(), Not(HasSubstr("no")));
}

class Resume : public StudyFolderTest {
 protected:
  Resume() {
    StudyFolder study = open();
    for (size_t i = 0; i < 4; ++i) finish_cell(study, i);
    study.finish();
  }
  std::vector<size_t> done(bool fresh = false, const std::string& drawing = "") {
    const StudyFolder study = open(fresh, drawing);
    std::vector<size_t> cells;
    for (size_t i = 0; i < 4; ++i) {
      if (study.is_done(i)) cells.push_back(i);
    }
    return cells;
  }
};

TEST_F(Resume, keeps_what_is_intact) {
  const std::string before = data();
  EXPECT_THAT(done(), ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(data(), before);
}

TEST_F(Resume, a_fresh_start_keeps_nothing) {
  EXPECT_TRUE(done(true).empty());
  EXPECT_EQ(journal(), "");
  EXPECT_TRUE(done().empty()) << "the journal was started anew";
}

TEST_F(Resume, drops_cells_whose_key_is_another_now) {
  EXPECT_TRUE(done(false, "shader changed").empty());
}

TEST_F(Resume, other_numbers_keep_the_pictures_until_they_are_measured_again) {
  {
    const StudyFolder study = open(false, "", "thinning changed");
    for (size_t i = 0; i < 4; ++i) EXPECT_EQ(study.work(i), CellWork::measure);
    EXPECT_THAT(data(), Not(HasSubstr("\n1,"))) << "no old number stands beside a new one";
  }
  std::optional<StudyFolder> held(std::in_place, spec_, folder_.path(), keys_of(4, "", "thinning changed"),
                                  kOrigin, false);
  StudyFolder& study = *held;
  ASSERT_EQ(study.work(2), CellWork::measure) << "a run that was killed before loses no picture";
  study.add(2, {"0.75", "7"}, {});
  EXPECT_THAT(data(), HasSubstr("\n3,0.25,\"a, \"\"b\"\".obj\",0.75,7,,cells/0003_final.png,"));
  study.finish();
  held.reset();  // lets go of the folder
  EXPECT_EQ(open(false, "", "thinning changed").work(2), CellWork::none);
}

TEST_F(Resume, other_pictures_are_drawn_whatever_their_numbers) {
  EXPECT_EQ(open(false, "shader changed", "thinning changed").work(0), CellWork::draw);
}

TEST_F(Resume, says_how_many_cells_are_made_again_and_why) {
  EXPECT_TRUE(open().notes().empty());
  const auto note = [&](const ResultOrigin& origin, const std::string& drawing,
                        const std::string& measuring) {
    const TemporaryFolder copy;
    fs::copy(folder_.path(), copy.path(), fs::copy_options::recursive);
    return join(StudyFolder(spec_, copy.path(), keys_of(4, drawing, measuring), origin, false).notes(), "; ");
  };
  EXPECT_EQ(note(kOrigin, "x", ""), "4 cells are drawn again: their settings or what they show changed");
  EXPECT_EQ(note({"drawing 2", "measuring 2", "softpipe"}, "x", ""),
            "4 cells are drawn again: the sources that draw changed");
  EXPECT_EQ(note({"drawing 1", "measuring 1", "swrast"}, "x", ""),
            "4 cells are drawn again: they were drawn by another renderer (softpipe; this is swrast)");
  EXPECT_EQ(note(kOrigin, "", "x"),
            "4 cells are measured again: what is measured, or how it is judged, changed");
  EXPECT_EQ(note({"drawing 1", "measuring 2", "softpipe"}, "", "x"),
            "4 cells are measured again: the sources that measure changed");
  fs::remove(folder_.path() / "cells/0004_final.png");
  EXPECT_EQ(note(kOrigin, "", ""), "1 cell is drawn again: their files are missing or were changed");
}

TEST_F(Resume, a_journal_of_before_is_not_trusted_and_that_is_said) {
  folder_.write("journal.jsonl", R"({"cell":0,"key":"0123","numbers":["1","2"],"files":[]})"
                                 "\n");
  const StudyFolder study = open();
  EXPECT_EQ(study.work(0), CellWork::draw);
  EXPECT_THAT(study.notes(), ElementsAre(HasSubstr("1 cell is drawn again: an older inkbench")));
}

TEST_F(Resume, drops_the_cell_with_a_changed_file_and_its_row) {
  folder_.write("cells/0002_depth.png", "picture X");
  EXPECT_THAT(done(), ElementsAre(0, 2, 3));
  EXPECT_THAT(data(), Not(HasSubstr("\n2,")));
  EXPECT_THAT(data(), HasSubstr("\n3,"));
}

TEST_F(Resume, drops_the_cell_with_a_missing_file) {
  fs::remove(folder_.path() / "cells/0004_final.png");
  EXPECT_THAT(done(), ElementsAre(0, 1, 2));
}

TEST_F(Resume, drops_a_torn_last_line) {
  folder_.write("journal.jsonl", journal().substr(0, journal().size() - 5));
  EXPECT_THAT(done(), ElementsAre(0, 1, 2));
}

TEST_F(Resume, data_csv_follows_the_journal_whatever_it_said) {
  const std::string before = data();
  folder_.write("data.csv", "half a li");
  EXPECT_THAT(done(), ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(data(), before);
}

TEST_F(Resume, drops_everything_when_other_buffers_are_shown) {
  spec_.show = {BufferName::final};
  EXPECT_TRUE(done().empty());
  spec_.show = {BufferName::depth, BufferName::final};
  EXPECT_TRUE(done().empty()) << "the same in another order";
}

TEST_F(Resume, drops_records_of_cells_that_are_no_more) {
  const StudyFolder smaller(spec_, folder_.path(), keys_of(2), kOrigin, false);
  EXPECT_EQ(smaller.done_count(), 2U);
}

TEST_F(Resume, measures_records_with_other_numbers_again) {
  change_record(2, [](CellRecord& record) { record.numbers.pop_back(); });
  EXPECT_EQ(open().work(2), CellWork::measure);
  EXPECT_THAT(done(), ElementsAre(0, 1, 3));
}

TEST_F(Resume, a_changed_digit_of_a_number_in_the_journal_is_found_and_said) {
  std::string changed = journal();
  const size_t place = changed.find("\"0.5\"");
  ASSERT_NE(place, std::string::npos);
  folder_.write("journal.jsonl", changed.replace(place, 5, "\"0.6\""));
  const StudyFolder study = open();
  EXPECT_EQ(study.done_count(), 3U);
  EXPECT_THAT(data(), Not(HasSubstr("0.6")));
  EXPECT_THAT(study.notes(), ElementsAre("1 cell is drawn again: the journal's line is damaged"));
}

class ResumeWithLines : public StudyFolderTest {
 protected:
  ResumeWithLines() {
    spec_ = parse_spec("measure = [\"f1\"]\n[[axis]]\nkey = \"combine.k_depth\"\nvalues = [1, 0.5]\n",
                       "/studies/s.toml", {});
    StudyFolder study = open();
    for (size_t i = 0; i < 2; ++i) finish_cell(study, i);
    study.finish();
  }
};

TEST_F(ResumeWithLines, are_kept_where_they_are_intact) {
  const StudyFolder study = open();
  EXPECT_EQ(study.done_count(), 2U);
  EXPECT_EQ(study.overlay_file(1, 0), "reference/0000000000000001.svg");
}

TEST_F(ResumeWithLines, lines_that_lie_elsewhere_are_found_again_without_drawing) {
  const std::string good = "reference/0000000000000001.svg";
  const std::string before = journal();
  for (const char* bad : {"reference//000000000000001.svg", "reference/../0000000000001.svg",
                          "referenc/00000000000000001.svg", "reference/000000000000000g.svg"}) {
    folder_.write("journal.jsonl", before);
    change_record(1, [&](CellRecord& record) { record.overlays.at(0).name = bad; });
    folder_.write(bad, "lines");
    const StudyFolder study = open();
    EXPECT_EQ(study.work(0), CellWork::none) << bad;
    EXPECT_EQ(study.work(1), CellWork::measure) << bad;
    folder_.write(good, "lines");
  }
}

TEST_F(ResumeWithLines, without_measures_the_lines_go) {
  spec_.measures.clear();
  const StudyFolder study = open(false, "", "no measures");
  EXPECT_EQ(study.work(0), CellWork::measure);
  EXPECT_FALSE(fs::exists(folder_.path() / "reference/0000000000000000.svg"));
}

TEST_F(StudyFolderTest, files_get_more_digits_in_large_studies) {
  {
    const StudyFolder small(spec_, folder_.path(), keys_of(9999), kOrigin, false);
    EXPECT_EQ(small.cell_file(0, 0, BufferName::final), "cells/0001_final.png");
  }
  const StudyFolder large(spec_, folder_.path(), keys_of(10'000), kOrigin, false);
  EXPECT_EQ(large.cell_file(0, 0, BufferName::final), "cells/00001_final.png");
}

TEST_F(StudyFolderTest, a_study_that_outgrew_its_digits_draws_again_what_data_csv_could_not_find) {
  {
    StudyFolder small(spec_, folder_.path(), keys_of(4), kOrigin, false);
    finish_cell(small, 0);
  }
  const StudyFolder large(spec_, folder_.path(), keys_of(10'000), kOrigin, false);
  EXPECT_FALSE(large.is_done(0));
}

TEST_F(StudyFolderTest, threads_may_add_at_the_same_time) {
  spec_ = parse_spec("[[axis]]\nkey = \"combine.k_depth\"\nfrom = 0.01\nto = 1\ncount = 200\n",
                     "/studies/s.toml", {});
  std::optional<StudyFolder> held(std::in_place, spec_, folder_.path(), keys_of(200), kOrigin, false);
  StudyFolder& study = *held;
  std::vector<std::thread> threads;
  for (size_t first = 0; first < 4; ++first) {
    threads.emplace_back([&, first] {
      for (size_t i = first; i < 200; i += 4) finish_cell(study, i);
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(study.done_count(), 200U);
  const std::string grown = data();
  EXPECT_EQ(std::count(grown.begin(), grown.end(), '\n'), 201);
  study.finish();
  EXPECT_EQ(data().size(), grown.size()) << "the same rows, sorted";
  held.reset();  // lets go of the folder
  EXPECT_EQ(open().done_count(), 200U);
}

TEST_F(StudyFolderTest, a_cell_without_its_files_cannot_be_added) {
  StudyFolder study = open();
  error_of([&] { study.add(0, {"0", "0"}, {}); });
  EXPECT_FALSE(study.is_done(0));
}

TEST_F(StudyFolderTest, a_folder_that_cannot_be_made_is_an_error) {
  const fs::path file = folder_.write("file", "x");
  EXPECT_THAT(error_of([&] { StudyFolder(spec_, file, keys_of(4), kOrigin, false); }, ErrorKind::work),
              HasSubstr("this folder cannot be made"));
}

TEST_F(StudyFolderTest, a_row_that_cannot_be_added_is_an_error) {
  StudyFolder study = open();
  fs::remove(folder_.path() / "data.csv");
  fs::create_directory(folder_.path() / "data.csv");
  EXPECT_THAT(error_of([&] { study.add_failure(0, "x"); }, ErrorKind::work),
              HasSubstr("data.csv: a row could not be added"));
}

}  // namespace
}  // namespace inkbench
