// SPDX-License-Identifier: MIT
// What a typed name to save under means, and what is looked at before anything is written.
#include "app/workbench/save_place.h"

#include <array>

#include "tests/workbench/workbench_support.h"

namespace inkbench {
namespace {

using ::testing::HasSubstr;

constexpr std::array<std::string_view, 2> kPictures{".png", ".exr"};

TEST(SavePlace, name_gets_an_ending_where_it_has_none_that_can_be_written) {
  EXPECT_EQ(save_path("a", "/x", kPictures), "/x/a.png");
  EXPECT_EQ(save_path("a.exr", "/x", kPictures), "/x/a.exr");
  EXPECT_EQ(save_path("v1.2", "/x", kPictures), "/x/v1.2.png");
  EXPECT_EQ(save_path("/y/a.png", "/x", kPictures), "/y/a.png");
  EXPECT_EQ(save_path("../a.png", "/x/z", kPictures), "/x/a.png");
  EXPECT_EQ(save_path(" ", "/x", kPictures), "");
}

TEST(SavePlace, folder_stays_one_and_is_no_place_for_a_file) {
  const TemporaryFolder folder;
  EXPECT_EQ(save_path(folder.path().string(), "/x", kPictures), folder.path());
  EXPECT_THAT(save_problem(folder.path()), HasSubstr("is a folder"));
}

TEST(SavePlace, folder_that_is_not_there_is_told_and_a_file_is_none) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a", "");
  EXPECT_EQ(save_problem(folder.path() / "b"), "");
  EXPECT_THAT(save_problem(folder.path() / "no/b"), HasSubstr("There is no folder"));
  EXPECT_THAT(save_problem(file / "b"), HasSubstr("no folder"));
}

TEST(SavePlace, is_taken_by_a_link_that_leads_nowhere_too) {
  const TemporaryFolder folder;
  fs::create_symlink("nowhere", folder.path() / "link");
  EXPECT_TRUE(is_taken(folder.path() / "link"));
  EXPECT_FALSE(is_taken(folder.path() / "other"));
}

}  // namespace
}  // namespace inkbench
