// SPDX-License-Identifier: MIT
// A program beside us: what it writes arrives line by line, and nothing of it is left behind.
#include "app/workbench/child_process.h"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "tests/unit/support.h"

namespace inkbench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kLong = 20.0;

std::vector<std::string> shell(const std::string& script) {
  return {"/bin/sh", "-c", script};
}

/// Whether the process is there, or waits for somebody to ask for its end.
bool exists(pid_t process) {
  return kill(process, 0) == 0;
}

TEST(ChildProcess, lines_of_both_streams_arrive_whole_and_a_last_one_without_its_end) {
  ChildProcess child(shell("printf 'one\\ntwo\\nrest'; echo wrong >&2"));
  ASSERT_TRUE(child.wait_for_end(kLong));
  const ChildProcess::Lines lines = child.take_lines();
  EXPECT_THAT(lines.out, ElementsAre("one", "two", "rest"));
  EXPECT_THAT(lines.err, ElementsAre("wrong"));
  EXPECT_THAT(child.take_lines().out, IsEmpty());
  EXPECT_EQ(child.exit_status(), 0);
}

TEST(ChildProcess, half_a_line_waits_for_its_rest) {
  ChildProcess child(shell("printf 'ha'; read nothing; sleep 0.2; printf 'lf\\n'"));
  std::vector<std::string> lines;
  while (lines.empty() && child.is_running()) lines = child.take_lines().out;
  if (lines.empty()) lines = child.take_lines().out;
  EXPECT_THAT(lines, ElementsAre("half"));
}

TEST(ChildProcess, says_how_it_ended) {
  ChildProcess failing(shell("exit 3"));
  ASSERT_TRUE(failing.wait_for_end(kLong));
  EXPECT_EQ(failing.exit_status(), 3);
  EXPECT_EQ(failing.signal(), 0);
  ChildProcess killed(shell("exec sleep 60"));
  EXPECT_FALSE(killed.wait_for_end(0.02));
  EXPECT_TRUE(killed.is_running());
  killed.send(SIGINT);
  ASSERT_TRUE(killed.wait_for_end(kLong));
  EXPECT_EQ(killed.signal(), SIGINT);
  EXPECT_FALSE(killed.exit_status());
}

TEST(ChildProcess, a_program_that_is_not_there_is_told) {
  EXPECT_THAT(error_of([] { ChildProcess child({"/no/such/program"}); }, ErrorKind::work),
              HasSubstr("/no/such/program: cannot be started: No such file"));
  EXPECT_THAT(error_of([] { start_detached({"no-such-program-of-ours"}); }, ErrorKind::work),
              HasSubstr("cannot be started"));
}

TEST(ChildProcess, its_end_is_ours_and_no_zombie_stays) {
  pid_t process = 0;
  {
    ChildProcess child(shell("exec sleep 60"));
    process = child.id();
    EXPECT_TRUE(exists(process));
  }
  EXPECT_FALSE(exists(process));
}

TEST(ChildProcess, ends_with_a_parent_that_is_killed) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t parent = fork();
  if (parent == 0) {
    ChildProcess child(shell("exec sleep 60"));
    const pid_t process = child.id();
    if (write(ends[1], &process, sizeof(process)) < 0) _exit(1);
    pause();
    _exit(0);
  }
  pid_t process = 0;
  ASSERT_EQ(read(ends[0], &process, sizeof(process)), static_cast<ssize_t>(sizeof(process)));
  EXPECT_TRUE(exists(process));
  kill(parent, SIGKILL);
  waitpid(parent, nullptr, 0);
  for (int i = 0; i < 400 && exists(process); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  // Where nobody collects orphans, as in some containers, it stays as a zombie of the system's first process.
  const std::string stat = "/proc/" + std::to_string(process) + "/cmdline";
  std::ifstream stream(stat);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), "") << "it still runs";
  close(ends[0]);
  close(ends[1]);
}

TEST(ChildProcess, a_detached_program_runs_without_us) {
  const TemporaryFolder folder;
  const auto mark = folder.path() / "mark";
  start_detached({"sh", "-c", "echo > '" + mark.string() + "'"});
  for (int i = 0; i < 400 && !std::filesystem::exists(mark); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_TRUE(std::filesystem::exists(mark));
}

}  // namespace
}  // namespace inkbench
