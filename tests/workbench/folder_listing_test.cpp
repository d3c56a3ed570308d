// SPDX-License-Identifier: MIT
// Folders as a file chooser lists them, and paths as people type them.
#include "app/workbench/folder_listing.h"

#include <cstdlib>

#include "tests/workbench/workbench_support.h"

namespace inkbench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> names_in(const FolderListing& listing) {
  std::vector<std::string> names;
  for (const FolderEntry& entry : listing.entries) names.push_back(entry.name);
  return names;
}

TEST(FolderListing, folders_come_first_and_case_does_not_matter) {
  const TemporaryFolder folder;
  for (const char* name : {"b.png", "A.PNG", "c.txt", ".hidden.png"}) folder.write(name, "123");
  std::filesystem::create_directory(folder.path() / "z");
  std::filesystem::create_directory(folder.path() / ".git");
  constexpr std::array<std::string_view, 1> kPng{".png"};
  const FolderListing listing = list_folder(folder.path(), kPng);
  EXPECT_THAT(names_in(listing), ElementsAre("z", "A.PNG", "b.png"));
  EXPECT_THAT(names_in(list_folder(folder.path(), {})), ElementsAre("z", "A.PNG", "b.png", "c.txt"));
  EXPECT_EQ(listing.entries[1].bytes, 3U);
  EXPECT_EQ(listing.problem, "");
}

TEST(FolderListing, says_why_it_is_empty) {
  const TemporaryFolder folder;
  EXPECT_THAT(list_folder(folder.path() / "none", {}).problem, HasSubstr("No such file"));
  EXPECT_THAT(list_folder(folder.write("file", ""), {}).problem, HasSubstr("Not a directory"));
  EXPECT_EQ(list_folder(folder.path(), {}).entries.size(), 1U);
}

TEST(FolderListing, names_that_are_not_utf8_and_pipes_are_left_out) {
  const TemporaryFolder folder;
  folder.write("\xff.toml", "");
  EXPECT_THAT(names_in(list_folder(folder.path(), {})), IsEmpty());
}

TEST(PathFromText, takes_what_people_type_and_paste) {
  EXPECT_EQ(path_from_text("a/../b.toml", "/x"), "/x/b.toml");
  EXPECT_EQ(path_from_text("  '/a b/c.png'\n", "/x"), "/a b/c.png");
  EXPECT_EQ(path_from_text("file:///a%20b/%C3%BC.png\r\n", "/x"), "/a b/ü.png");
  EXPECT_EQ(path_from_text("100%.png", "/x"), "/x/100%.png");
  EXPECT_EQ(path_from_text(" \n", "/x"), "");
  EXPECT_EQ(path_from_text("~/q", "/x"), std::string(std::getenv("HOME")) + "/q");
  EXPECT_EQ(path_text(std::string(std::getenv("HOME")) + "/q r"), "~/q r");
  EXPECT_EQ(path_text(std::string(std::getenv("HOME")) + "x/q"), std::string(std::getenv("HOME")) + "x/q");
  EXPECT_EQ(path_text("/elsewhere/q"), "/elsewhere/q");
  EXPECT_EQ(path_from_text("~q", "/x"), "/x/~q");
}

}  // namespace
}  // namespace inkbench
