// SPDX-License-Identifier: MIT
// Files read whole and written all or nothing.
#include "pipeline/base/files.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <sys/resource.h>
#include <csignal>
#include <stdexcept>
#include <vector>

#include "tests/unit/support.h"

namespace inkbench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::UnorderedElementsAre;

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  return names;
}

std::span<const uint8_t> text_bytes(std::string_view text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

TEST(Files, what_was_written_is_read) {
  const TemporaryFolder folder;
  const std::string content = std::string("a\0b\r\n\xff", 6) + std::string(100'000, 'x');
  write_file_atomically(folder.path() / "file", content);
  EXPECT_EQ(read_file(folder.path() / "file"), content);
  write_file_atomically(folder.path() / "empty", "");
  EXPECT_EQ(read_file(folder.path() / "empty"), "");
}

TEST(Files, writing_replaces_the_content_and_leaves_nothing_else) {
  const TemporaryFolder folder;
  folder.write("file", "a much longer old content");
  write_file_atomically(folder.path() / "file", "new");
  EXPECT_EQ(read_file(folder.path() / "file"), "new");
  EXPECT_THAT(names_in(folder.path()), ElementsAre("file"));
}

TEST(Files, writing_makes_the_parent_folders) {
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "a" / "b" / "file", "new");
  EXPECT_EQ(read_file(folder.path() / "a" / "b" / "file"), "new");
}

TEST(Files, pieces_are_written_in_order) {
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "file", [](const FileSink& sink) {
    sink(text_bytes("one "));
    sink({});
    sink(text_bytes("two"));
  });
  EXPECT_EQ(read_file(folder.path() / "file"), "one two");
}

TEST(Files, a_writer_that_throws_keeps_the_old_content_and_removes_its_own) {
  const TemporaryFolder folder;
  folder.write("file", "old");
  const auto write_half = [&] {
    write_file_atomically(folder.path() / "file", [](const FileSink& sink) {
      sink(text_bytes("half"));
      throw std::runtime_error("stop");
    });
  };
  EXPECT_THROW(write_half(), std::runtime_error);
  EXPECT_EQ(read_file(folder.path() / "file"), "old");
  EXPECT_THAT(names_in(folder.path()), ElementsAre("file"));
}

TEST(Files, the_name_holds_the_old_content_until_the_end) {
  const TemporaryFolder folder;
  folder.write("file", "old");
  PendingFile pending(folder.path() / "file");
  pending.append(text_bytes("new"));
  EXPECT_EQ(read_file(folder.path() / "file"), "old");
  pending.commit();
  EXPECT_EQ(read_file(folder.path() / "file"), "new");
}

TEST(Files, a_pending_file_that_is_not_committed_disappears) {
  const TemporaryFolder folder;
  {
    PendingFile pending(folder.path() / "file");
    pending.append(text_bytes("new"));
    EXPECT_EQ(names_in(folder.path()).size(), 1U);
  }
  EXPECT_TRUE(names_in(folder.path()).empty());
}

TEST(Files, two_pending_files_of_one_name_do_not_meet) {
  const TemporaryFolder folder;
  PendingFile first(folder.path() / "file");
  PendingFile second(folder.path() / "file");
  first.append(text_bytes("first"));
  second.append(text_bytes("second"));
  second.commit();
  first.commit();
  EXPECT_EQ(read_file(folder.path() / "file"), "first");
  EXPECT_THAT(names_in(folder.path()), ElementsAre("file"));
}

TEST(Files, writing_over_a_folder_is_an_error_that_leaves_nothing) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "taken");
  const std::string text =
      error_of([&] { write_file_atomically(folder.path() / "taken", "x"); }, ErrorKind::work);
  EXPECT_THAT(text, StartsWith((folder.path() / "taken").string() + ": cannot be written"));
  EXPECT_THAT(names_in(folder.path()), ElementsAre("taken"));
}

TEST(Files, writing_under_a_file_says_which_folder_cannot_be_made) {
  const TemporaryFolder folder;
  folder.write("file", "x");
  const std::string text =
      error_of([&] { write_file_atomically(folder.path() / "file" / "inner", "x"); }, ErrorKind::work);
  EXPECT_THAT(text, HasSubstr((folder.path() / "file").string() + ": this folder cannot be made"));
}

TEST(Files, writing_past_the_size_limit_is_an_error_that_leaves_the_old_content) {
  const TemporaryFolder folder;
  folder.write("file", "old");
  rlimit saved{};
  getrlimit(RLIMIT_FSIZE, &saved);
  const auto saved_handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{4096, saved.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string text = error_of(
      [&] { write_file_atomically(folder.path() / "file", std::string(10'000, 'x')); }, ErrorKind::work);
  setrlimit(RLIMIT_FSIZE, &saved);
  std::signal(SIGXFSZ, saved_handler);
  EXPECT_THAT(text, HasSubstr("writing stopped; the file would exceed the allowed file size"));
  EXPECT_EQ(read_file(folder.path() / "file"), "old");
  EXPECT_THAT(names_in(folder.path()), ElementsAre("file"));
}

TEST(Files, a_name_too_long_is_our_error) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / std::string(300, 'n');
  error_of([&] { write_file_atomically(path, "x"); }, ErrorKind::work);
  error_of([&] { make_folder(path); }, ErrorKind::work);
  error_of([&] { read_file(path); });
}

TEST(Files, reading_says_what_is_wrong_with_the_path) {
  const TemporaryFolder folder;
  EXPECT_EQ(error_of([&] { read_file(folder.path() / "none"); }),
            (folder.path() / "none").string() + ": no such file");
  EXPECT_EQ(error_of([&] { read_file(folder.path()); }),
            folder.path().string() + ": is a folder; a file is needed");
  EXPECT_EQ(error_of([] { read_file("/dev/zero"); }), "/dev/zero: is a device; a file is needed");
}

TEST(Files, make_folder_accepts_one_that_exists) {
  const TemporaryFolder folder;
  make_folder(folder.path() / "a" / "b");
  make_folder(folder.path() / "a" / "b");
  EXPECT_TRUE(fs::is_directory(folder.path() / "a" / "b"));
}

TEST(Files, project_files_are_found_under_the_variable_first) {
  EXPECT_TRUE(fs::is_regular_file(project_file("data/scenes/paper.toml")));
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "shaders");
  setenv("INKBENCH_ROOT", folder.path().c_str(), 1);
  EXPECT_NE(project_root(), folder.path()) << "it has no data/";
  fs::create_directories(folder.path() / "data");
  EXPECT_EQ(project_file("data/x"), folder.path() / "data/x");
  unsetenv("INKBENCH_ROOT");
}

}  // namespace
}  // namespace inkbench
