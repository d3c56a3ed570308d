// SPDX-License-Identifier: MIT
// Folders that disappear with the object that made them.
#include "pipeline/base/scratch_folder.h"

#include <gmock/gmock.h>

#include "tests/unit/support.h"

namespace inkbench {
namespace {

using ::testing::HasSubstr;

TEST(ScratchFolder, is_empty_and_another_one_each_time) {
  const ScratchFolder one, other;
  EXPECT_NE(one.path(), other.path());
  EXPECT_EQ(one.path().parent_path(), temporary_place());
  EXPECT_TRUE(fs::is_directory(one.path()) && fs::is_empty(one.path()));
}

TEST(ScratchFolder, disappears_with_all_that_lies_in_it) {
  fs::path path;
  {
    const ScratchFolder scratch(memory_place());
    path = scratch.path();
    fs::create_directories(path / "a" / "b");
    std::ofstream(path / "a" / "file") << "content";
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST(ScratchFolder, sweeps_what_killed_runs_left_and_nothing_else) {
  const ScratchFolder place;
  const ScratchFolder living(place.path());
  const fs::path left = place.path() / "inkbench_0123456789abcdef",
                 linked = place.path() / "inkbench_1111111111111111";
  for (const fs::path& folder : {left, linked, place.path() / "inkbench_other", place.path() / "theirs"})
    fs::create_directories(folder / "inner");
  std::ofstream(left.string() + ".lock") << "";
  fs::create_symlink("theirs", linked.string() + ".lock");
  const ScratchFolder next(place.path());
  EXPECT_FALSE(fs::exists(left) || fs::exists(left.string() + ".lock"));
  for (const fs::path& kept : {living.path(), next.path(), place.path() / "inkbench_other" / "inner",
                               place.path() / "theirs" / "inner", linked / "inner"})
    EXPECT_TRUE(fs::exists(kept)) << kept;
}

TEST(ScratchFolder, that_cannot_be_made_is_an_error_that_names_it_and_says_why) {
  const auto make = [] { const ScratchFolder scratch("/nowhere"); };
  const std::string message = error_of(make, ErrorKind::work);
  EXPECT_THAT(message, HasSubstr("/nowhere/inkbench_"));
  EXPECT_THAT(message, HasSubstr("cannot be made; No such file or directory"));
}

}  // namespace
}  // namespace inkbench
