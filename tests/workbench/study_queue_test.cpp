// SPDX-License-Identifier: MIT
// Studies one after the other, with a script in the place of the program: progress, errors, stopping.
#include "app/workbench/study_queue.h"

#include <gmock/gmock.h>

#include <chrono>
#include <functional>
#include <thread>

#include "tests/unit/support.h"

namespace inkbench {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class StudyQueueTest : public testing::Test {
 protected:
  /// The program does what `script` says; "$5" is nothing, "$4" the folder, "$2" the spec.
  StudyQueue queue(const std::string& script) {
    const auto program = folder_.write("program", "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    return StudyQueue(program);
  }

  std::filesystem::path out(const std::string& name) const { return folder_.path() / name; }

  static void poll_until(StudyQueue& queue, const std::function<bool()>& holds) {
    for (int i = 0; i < 2000 && !holds(); ++i) {
      queue.poll();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ASSERT_TRUE(holds());
  }

  TemporaryFolder folder_;
};

const std::string kProgress = R"(echo '{"done":2,"total":4,"drawn":2,"failed":1,"seconds":6.0}')";

TEST_F(StudyQueueTest, runs_the_command_that_a_person_would) {
  StudyQueue studies = queue(R"(echo "$@" > ")" + (folder_.path() / "words").string() + "\"");
  studies.add("One", "/specs/one.toml", out("one"));
  poll_until(studies, [&] { return !studies.is_busy(); });
  std::ifstream words(folder_.path() / "words");
  std::string line;
  std::getline(words, line);
  EXPECT_EQ(line, "study /specs/one.toml --out " + out("one").string() + " --progress json");
}

TEST_F(StudyQueueTest, tells_progress_and_what_is_left) {
  StudyQueue studies = queue("echo 'One: 4 cells'; " + kProgress + "; sleep 60");
  studies.add("One", "one.toml", out("one"));
  EXPECT_EQ(studies.jobs()[0].state, StudyState::waiting);
  poll_until(studies, [&] { return studies.jobs()[0].total == 4; });
  const StudyJob& job = studies.jobs()[0];
  EXPECT_EQ(job.state, StudyState::running);
  EXPECT_EQ(job.done, 2U);
  EXPECT_EQ(job.failed, 1U);
  EXPECT_DOUBLE_EQ(job.seconds_left(), 2.0) << "three cells took 6 s, one is left";
}

TEST_F(StudyQueueTest, one_runs_after_the_other) {
  StudyQueue studies = queue("echo x >> " + (folder_.path() / "running").string() + "; sleep 0.1; " +
                             "echo '{\"done\":1,\"total\":1,\"drawn\":1,\"failed\":0,\"seconds\":1}'");
  studies.add("One", "one.toml", out("one"));
  studies.add("Two", "two.toml", out("two"));
  poll_until(studies, [&] { return studies.jobs()[0].state == StudyState::running; });
  EXPECT_EQ(studies.jobs()[1].state, StudyState::waiting);
  poll_until(studies, [&] { return !studies.is_busy(); });
  for (const StudyJob& job : studies.jobs()) EXPECT_EQ(job.state, StudyState::finished) << job.title;
}

TEST_F(StudyQueueTest, the_same_folder_waits_once_and_can_run_again) {
  StudyQueue studies = queue("sleep 60");
  const int first = studies.add("One", "one.toml", out("one"));
  EXPECT_EQ(studies.add("One", "one.toml", out("one")), first);
  EXPECT_EQ(studies.jobs().size(), 1U);
  studies.cancel(first);
  EXPECT_EQ(studies.jobs()[0].state, StudyState::stopped);
  EXPECT_NE(studies.add("One", "one.toml", out("one")), first);
  EXPECT_EQ(studies.jobs().size(), 1U);
  EXPECT_EQ(studies.jobs()[0].state, StudyState::waiting);
}

TEST_F(StudyQueueTest, errors_are_told_and_the_next_one_runs) {
  StudyQueue studies =
      queue(R"(if [ "$2" = bad.toml ]; then echo 'inkbench: error: bad.toml:3: no' >&2; exit 2; fi)");
  studies.add("Bad", "bad.toml", out("bad"));
  studies.add("Good", "good.toml", out("good"));
  poll_until(studies, [&] { return !studies.is_busy(); });
  EXPECT_EQ(studies.jobs()[0].state, StudyState::failed);
  EXPECT_EQ(studies.jobs()[0].problem, "bad.toml:3: no");
  EXPECT_EQ(studies.jobs()[1].state, StudyState::finished);
  EXPECT_THAT(studies.take_messages(), Contains(StudyQueue::StudyMessage{true, "Bad: bad.toml:3: no"}));
  EXPECT_THAT(studies.take_messages(), IsEmpty());
}

TEST_F(StudyQueueTest, notes_are_no_errors_and_the_same_one_of_each_cell_is_told_once) {
  StudyQueue studies = queue(R"(for i in 1 2 3; do echo 'inkbench: note: a face was dropped' >&2; done)");
  studies.add("One", "one.toml", out("one"));
  poll_until(studies, [&] { return !studies.is_busy(); });
  EXPECT_THAT(studies.take_messages(),
              ElementsAre(StudyQueue::StudyMessage{false, "One: a face was dropped"}));
  EXPECT_EQ(studies.jobs()[0].problem, "");
}

TEST_F(StudyQueueTest, cells_that_failed_leave_a_study_that_finished) {
  StudyQueue studies = queue(R"(echo '{"done":3,"total":4,"drawn":3,"failed":1,"seconds":1}'; exit 1)");
  studies.add("One", "one.toml", out("one"));
  poll_until(studies, [&] { return !studies.is_busy(); });
  EXPECT_EQ(studies.jobs()[0].state, StudyState::finished);
  EXPECT_EQ(studies.jobs()[0].failed, 1U);
}

TEST_F(StudyQueueTest, stopping_waits_for_the_cell_and_is_no_error) {
  StudyQueue studies = queue("trap 'echo \"inkbench: error: stopped after 2 of 4 cells\" >&2; exit 1' INT; " +
                             kProgress + "; while true; do sleep 0.05; done");
  const int number = studies.add("One", "one.toml", out("one"));
  poll_until(studies, [&] { return studies.jobs()[0].total == 4; });
  studies.cancel(number);
  EXPECT_EQ(studies.jobs()[0].state, StudyState::stopping);
  poll_until(studies, [&] { return !studies.is_busy(); });
  EXPECT_EQ(studies.jobs()[0].state, StudyState::stopped);
  EXPECT_EQ(studies.jobs()[0].problem, "");
  EXPECT_THAT(studies.take_messages(), IsEmpty());
}

TEST_F(StudyQueueTest, one_that_does_not_stop_is_ended_by_force) {
  StudyQueue studies = queue("trap '' INT; " + kProgress + "; while true; do sleep 0.05; done");
  studies.add("One", "one.toml", out("one"));
  studies.add("Two", "two.toml", out("two"));
  poll_until(studies, [&] { return studies.jobs()[0].total == 4; });
  studies.stop_all(0.1);
  EXPECT_FALSE(studies.is_busy());
  for (const StudyJob& job : studies.jobs()) EXPECT_EQ(job.state, StudyState::stopped) << job.title;
}

TEST_F(StudyQueueTest, a_crash_is_told) {
  StudyQueue studies = queue("kill -SEGV $$");
  studies.add("One", "one.toml", out("one"));
  poll_until(studies, [&] { return !studies.is_busy(); });
  EXPECT_EQ(studies.jobs()[0].state, StudyState::failed);
  EXPECT_THAT(studies.jobs()[0].problem, HasSubstr("Segmentation fault"));
}

TEST_F(StudyQueueTest, a_program_that_is_not_there_is_told) {
  StudyQueue studies(folder_.path() / "nothing");
  studies.add("One", "one.toml", out("one"));
  studies.poll();
  EXPECT_EQ(studies.jobs()[0].state, StudyState::failed);
  EXPECT_THAT(studies.jobs()[0].problem, HasSubstr("cannot be started"));
}

TEST_F(StudyQueueTest, damaged_progress_is_passed_over) {
  StudyQueue studies =
      queue(R"(echo '{"done":'; echo '{"done":-1,"total":"x"}'; echo '[]'; echo '{'; exit 0)");
  studies.add("One", "one.toml", out("one"));
  poll_until(studies, [&] { return !studies.is_busy(); });
  EXPECT_EQ(studies.jobs()[0].total, 0U);
}

}  // namespace
}  // namespace inkbench
