// SPDX-License-Identifier: MIT
// A study's folder as it is while cells end, and when it is damaged.
#include "app/workbench/study_results.h"

#include <nlohmann/json.hpp>

#include "tests/workbench/workbench_support.h"

namespace inkbench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string kSpec = R"(title = "A grid"
show = ["final", "depth"]
[[axis]]
key = "combine.k_depth"
values = [0.001, 0.003, 0.009]
[[axis]]
key = "combine.use_normal"
values = [true, false]
)";

const std::string kHead = "cell,combine.k_depth,combine.use_normal,ink,ink_px,error,FILE_final,FILE_depth\n";

std::string row(int cell, const std::string& ink) {
  const std::string number = "cells/000" + std::to_string(cell);
  return std::to_string(cell) + ",0.003,true," + ink + ",7,," + number + "_final.png," + number +
         "_depth.png\n";
}

class StudyResultsTest : public testing::Test {
 protected:
  StudyResultsTest() {
    write_manifest("running", kSpec);
    write_data(kHead);
  }
  void write_manifest(const std::string& state, const std::string& spec) {
    const nlohmann::json manifest{
        {"title", "A grid"}, {"state", state}, {"cells", 6}, {"spec_file", "s.toml"}, {"spec", spec}};
    folder_.write("out/manifest.json", manifest.dump());
  }
  /// A file in the place of the old one, as a study leaves one.
  void write_data(const std::string& text) {
    folder_.write("out/new.csv", text);
    fs::rename(folder() / "new.csv", folder() / "data.csv");
  }
  void append(const std::string& text) {
    std::ofstream(folder() / "data.csv", std::ios::app | std::ios::binary) << text;
  }
  fs::path folder() const { return folder_.path() / "out"; }

  TemporaryFolder folder_;
};

TEST_F(StudyResultsTest, grid_is_the_specs) {
  const StudyResults results(folder(), "");
  EXPECT_EQ(results.summary().title, "A grid");
  EXPECT_EQ(results.columns().label, "k_depth");
  EXPECT_THAT(results.columns().values, ElementsAre("0.001", "0.003", "0.009"));
  EXPECT_THAT(results.rows().values, ElementsAre("true", "false"));
  EXPECT_THAT(results.pages().values, ElementsAre(""));
  EXPECT_THAT(results.pictures(), ElementsAre("final", "depth"));
  EXPECT_THAT(results.numbers(), ElementsAre("ink", "ink_px"));
  EXPECT_EQ(results.cell_at(2, 1, 0), 5U);
  EXPECT_EQ(make_cell(results.spec(), results.cell_at(2, 1, 0)).name, "k_depth = 0.009, use_normal = false");
}

TEST_F(StudyResultsTest, charts_and_size_are_there_once_it_is_finished) {
  const std::string spec = kSpec +
                           "[[chart]]\nname = \"ink\"\ntitle = \"Ink\"\nx = \"combine.k_depth\"\n"
                           "y = \"ink\"\nby = \"combine.use_normal\"\n";
  write_manifest("running", spec);
  StudyResults results(folder(), "");
  EXPECT_EQ(results.charts().size(), 0U);
  EXPECT_EQ(results.bytes(), 0U);
  folder_.write("out/charts/ink.png", "abc");
  write_manifest("finished", spec);
  results.refresh();
  ASSERT_EQ(results.charts().size(), 1U);
  EXPECT_EQ(results.charts()[0].title, "Ink");
  EXPECT_EQ(results.charts()[0].png, folder() / "charts/ink.png");
  EXPECT_EQ(results.charts()[0].svg, folder() / "charts/ink.svg");
  EXPECT_EQ(results.bytes(), 3 + kHead.size() + fs::file_size(folder() / "manifest.json"));
}

TEST_F(StudyResultsTest, size_of_a_cell_is_what_it_was_run_with) {
  EXPECT_EQ(StudyResults(folder(), "").image(0, 0).width, paper_settings().image.width) << "not told";
  Settings base = paper_settings();
  base.image.width = 48;
  base.image.height = 32;
  nlohmann::json manifest{{"title", "A grid"}, {"state", "running"}, {"cells", 6}, {"spec_file", "s.toml"}};
  manifest["spec"] = kSpec + "[[axis]]\nkey = \"image.width\"\nvalues = [64]\n";
  manifest["base_settings"] = text(base);
  folder_.write("out/manifest.json", manifest.dump());
  const StudyResults results(folder(), "");
  EXPECT_EQ(results.image(5, 1).width, 64) << "the cell's own";
  EXPECT_EQ(results.image(5, 1).height, 32) << "of the base";
}

TEST_F(StudyResultsTest, cells_come_as_they_end) {
  StudyResults results(folder(), "");
  EXPECT_EQ(results.done(), 0U);
  EXPECT_FALSE(results.refresh());
  append(row(2, "0.25") + "5,0.003,false");
  EXPECT_TRUE(results.refresh());
  EXPECT_TRUE(results.has(1));
  EXPECT_FALSE(results.has(4)) << "half a row waits for its rest";
  EXPECT_EQ(results.picture(1, 1), folder() / "cells/0002_depth.png");
  EXPECT_EQ(results.number(1, 0), "0.25");
  append(",,,\"no, sorry\",,\n");
  EXPECT_TRUE(results.refresh());
  EXPECT_EQ(results.error(4), "no, sorry");
  EXPECT_TRUE(results.picture(4, 0).empty());
  EXPECT_EQ(results.done(), 1U);
  EXPECT_EQ(results.failed(), 1U);
}

TEST_F(StudyResultsTest, a_table_that_is_written_anew_is_read_anew) {
  StudyResults results(folder(), "");
  append(row(2, "0.25"));
  results.refresh();
  write_data(kHead + row(1, "0.5") + row(2, "0.75"));
  write_manifest("finished", kSpec);
  EXPECT_TRUE(results.refresh());
  EXPECT_EQ(results.number(1, 0), "0.75");
  EXPECT_EQ(results.done(), 2U);
  EXPECT_EQ(results.summary().state, "finished");
}

TEST_F(StudyResultsTest, another_study_in_the_same_folder_is_noticed) {
  StudyResults results(folder(), "");
  write_manifest("stopped", kSpec);
  results.refresh();
  EXPECT_FALSE(results.is_replaced());
  write_manifest("running", kSpec + "values = [1]\n");
  results.refresh();
  EXPECT_TRUE(results.is_replaced());
}

TEST_F(StudyResultsTest, rows_that_are_none_are_passed_over) {
  write_data(kHead + "x,1\n99,0.003,true,1,1,,a,b\n0,0.003,true,1,1,,a,b\n,\n" + row(3, "0.5"));
  const StudyResults results(folder(), "");
  EXPECT_EQ(results.done(), 1U);
  EXPECT_TRUE(results.has(2));
}

TEST_F(StudyResultsTest, folder_without_a_study_is_refused) {
  EXPECT_THAT(error_of([&] { StudyResults results(folder_.path(), ""); }), HasSubstr("holds no study"));
  folder_.write("out/manifest.json", "{\"spec\": 1");
  EXPECT_THAT(error_of([&] { StudyResults results(folder(), ""); }), HasSubstr("is not a study's manifest"));
  write_manifest("running", "title = 1");
  EXPECT_THAT(error_of([&] { StudyResults results(folder(), ""); }), HasSubstr("title"));
}

}  // namespace
}  // namespace inkbench
