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

TEST(Files, a_pipe_is_refused_without_waiting_for_a_writer) {
  const TemporaryFolder folder;
  const fs::path pipe = folder.path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(error_of([&] { read_file(pipe); }), pipe.string() + ": is not a regular file; a file is needed");
}

TEST(Files, a_file_that_holds_more_than_the_system_says_is_refused) {
  EXPECT_EQ(
      error_of([] { read_file("/proc/self/status"); }),
      "/proc/self/status: its size is 0 bytes, but more were read; it changed meanwhile, or is no file on "
      "a disk: copy it to one");
}

TEST(Files, a_file_that_the_system_cannot_read_is_our_error_and_not_a_shorter_file) {
  // Reading a process's memory at address 0 is EIO.
  EXPECT_EQ(error_of([] { read_file("/proc/self/mem"); }, ErrorKind::work),
            "/proc/self/mem: reading stopped after 0 of 0 bytes; Input/output error");
}

TEST(Files, more_than_the_limit_is_not_read) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("scene.toml", std::string(1001, ' '));
  EXPECT_EQ(read_file(file, 1001).size(), 1001U);
  EXPECT_EQ(error_of([&] { read_file(file, 1000); }),
            file.string() + ": is too large: 1.0 kB; at most 1.0 kB are read");
}

TEST(Files, a_part_is_read_as_far_as_there_is_one) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("file", "0123456789");
  EXPECT_EQ(read_file_part(file, 3, 4), "3456");
  EXPECT_EQ(read_file_part(file, 8, 4), "89");
  EXPECT_EQ(read_file_part(file, 12, 4), "");
}

TEST(Files, temporary_names_differ_and_a_planted_link_is_not_followed) {
  const TemporaryFolder folder;
  PendingFile first(folder.path() / "file"), second(folder.path() / "file");
  const std::vector<std::string> names = names_in(folder.path());
  ASSERT_EQ(names.size(), 2U);
  EXPECT_GE(names[0].size(), std::string("file.part").size() + 16) << "too short to be beyond guessing";
  folder.write("elsewhere", "theirs");
  fs::create_symlink("elsewhere", folder.path() / "file");
  second.append(text_bytes("ours"));
  second.commit();
  EXPECT_FALSE(fs::is_symlink(folder.path() / "file"));
  EXPECT_EQ(read_file(folder.path() / "elsewhere"), "theirs");
}

TEST(Files, what_a_killed_writer_left_is_removed_and_what_a_living_one_writes_is_not) {
  const TemporaryFolder folder;
  for (const char* name : {"a.png.part0123456789abcdef", "b.csv.part812-3", "c.part", "d.part12",
                           "e.partly-1", "f.part0123456789abcdeX"})
    folder.write(name, "x");
  fs::create_symlink("d.part12", folder.path() / "g.part0123456789abcdef");
  PendingFile living(folder.path() / "h");
  remove_abandoned_files(folder.path());
  EXPECT_THAT(names_in(folder.path()),
              UnorderedElementsAre("c.part", "d.part12", "e.partly-1", "f.part0123456789abcdeX",
                                   "g.part0123456789abcdef", StartsWith("h.part")));
  living.append(text_bytes("whole"));
  living.commit();
  EXPECT_EQ(read_file(folder.path() / "h"), "whole");
}

TEST(Files, a_folder_of_ours_that_is_a_link_is_an_error) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "elsewhere");
  fs::create_symlink("elsewhere", folder.path() / "cells");
  EXPECT_THAT(error_of([&] { make_inner_folder(folder.path() / "cells"); }, ErrorKind::work),
              HasSubstr("cells: is a link, and results are not written through one; remove it"));
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
