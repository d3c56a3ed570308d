// SPDX-License-Identifier: MIT
// Studies that run in the background, one after the other, each as `inkbench study` in a process of its own:
// whatever becomes of it, the window goes on. In: specs and folders. Out: how far each one is.
#pragma once

#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/workbench/child_process.h"

namespace inkbench {

enum class StudyState { waiting, running, stopping, finished, stopped, failed };

struct StudyJob {
  int number = 0;  ///< Of its own, for as long as the queue lives.
  std::string title;
  std::filesystem::path spec, folder;
  StudyState state = StudyState::waiting;
  size_t done = 0, total = 0, failed = 0;  ///< Cells; `total` is 0 until it is known.
  size_t drawn = 0;                        ///< In this run.
  double seconds = 0;                      ///< Of this run, as it last told.
  std::string problem;                     ///< What it wrote last of what went wrong.

  bool is_over() const { return state >= StudyState::finished; }
  /// From how fast it was so far; below 0 while that is not known.
  double seconds_left() const;
};

class StudyQueue {
 public:
  /// `program`: the path of `inkbench`.
  explicit StudyQueue(std::filesystem::path program) : program_(std::move(program)) {}
  ~StudyQueue();  // NOLINT(bugprone-exception-escape): see its body

  /// Runs the spec into the folder when those before it are over. One that waits or runs for that folder
  /// already is left as it is. Returns the job's number.
  int add(const std::string& title, const std::filesystem::path& spec, const std::filesystem::path& folder);

  /// Takes in what the running one tells and starts the next. Returns whether anything changed.
  bool poll();

  /// A waiting one is taken off; the running one ends after the cell that it draws, to be continued by
  /// another `add`. A second time, it ends at once.
  void cancel(int number);

  /// Cancels all and waits for the end of the running one: politely, then by force. Its folder can be
  /// continued in both cases.
  void stop_all(double patience_seconds);

  const std::vector<StudyJob>& jobs() const { return jobs_; }
  bool is_busy() const;

  /// What a study wrote.
  struct StudyMessage {
    bool is_problem = false;  ///< An error; else a note, which stops nothing.
    std::string text;
    bool operator==(const StudyMessage&) const = default;
  };
  /// Since the last call. What a study writes of each of its cells in the same words is told once.
  std::vector<StudyMessage> take_messages();

 private:
  StudyJob* running();
  void start(StudyJob& job);
  void take_line(StudyJob& job, const std::string& line);
  bool listen(StudyJob& job);
  void note_end(StudyJob& job);

  std::filesystem::path program_;
  std::vector<StudyJob> jobs_;
  std::unique_ptr<ChildProcess> process_;
  std::vector<StudyMessage> messages_;
  std::set<std::string> told_;  ///< Notes of the study that runs.
  int next_number_ = 1;
};

}  // namespace inkbench
