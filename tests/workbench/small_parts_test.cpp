// SPDX-License-Identifier: MIT
// Durations, places in messages, and the list of studies that ran.
#include "app/workbench/duration_text.h"
#include "app/workbench/place_in_text.h"
#include "app/workbench/recent_studies.h"
#include "tests/workbench/workbench_support.h"

namespace inkbench {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(DurationText, says_whole_seconds_minutes_and_hours) {
  EXPECT_EQ(duration_text(0), "0 s");
  EXPECT_EQ(duration_text(0.2), "1 s");
  EXPECT_EQ(duration_text(125), "2 min 5 s");
  EXPECT_EQ(duration_text(5400 * 2), "3 h 0 min");
  EXPECT_NO_THROW(duration_text(1e300));
}

TEST(PlaceInText, is_the_first_file_and_line) {
  EXPECT_EQ(place_in_text("shaders/combine.frag:12: 'q' : undeclared"), "shaders/combine.frag:12");
  EXPECT_EQ(place_in_text("cannot read \"/a/b.toml:3\""), "/a/b.toml:3");
  EXPECT_EQ(place_in_text("at 12:30:05 in x.glsl:7 (again y.glsl:8)"), "x.glsl:7");
}

TEST(PlaceInText, is_nothing_where_there_is_none) {
  for (const char* text :
       {"", "no such file", "took 12:30", "a: b", "http://x:80", "1.5:3", ":3", ".:3", "x.y:"})
    EXPECT_EQ(place_in_text(text), "") << text;
}

TEST(PlaceInText, becomes_a_whole_path_where_the_file_is_known) {
  EXPECT_EQ(whole_place("shaders/combine.frag:12"),
            (project_root() / "shaders/combine.frag").string() + ":12");
  EXPECT_EQ(whole_place("/a/b.frag:1"), "/a/b.frag:1");
  EXPECT_EQ(whole_place("no/such.frag:1"), "no/such.frag:1");
}

class RecentStudiesTest : public testing::Test {
 protected:
  fs::path file() const { return folder_.path() / "studies.toml"; }
  TemporaryFolder folder_;
};

TEST_F(RecentStudiesTest, what_is_saved_comes_back) {
  const std::vector<RecentStudy> studies{{"A \"title\"", "/specs/a b.toml", "/out/a"},
                                         {"", "/b.toml", "/out/b"}};
  save_recent_studies(file(), studies);
  EXPECT_EQ(load_recent_studies(file()), studies);
}

TEST_F(RecentStudiesTest, newest_is_first_and_each_folder_there_once) {
  std::vector<RecentStudy> studies;
  for (int i = 0; i < 40; ++i) add_recent_study(studies, {"t", "s", "/out/" + std::to_string(i)});
  EXPECT_EQ(studies.size(), kMaxRecentStudies);
  add_recent_study(studies, {"again", "s", "/out/39"});
  EXPECT_EQ(studies[0].title, "again");
  EXPECT_EQ(studies[1].folder, "/out/38");
}

TEST_F(RecentStudiesTest, missing_list_is_empty_and_a_damaged_one_is_told) {
  EXPECT_THAT(load_recent_studies(file()), IsEmpty());
  folder_.write("studies.toml", "[[study]]\ntitle = \"x\"\n");
  EXPECT_THAT(error_of([&] { load_recent_studies(file()); }), HasSubstr("studies.toml:1"));
  folder_.write("studies.toml", "study = 3\n");
  EXPECT_THAT(error_of([&] { load_recent_studies(file()); }), HasSubstr("studies.toml:1"));
}

}  // namespace
}  // namespace inkbench
