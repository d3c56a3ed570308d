// SPDX-License-Identifier: MIT
// A search beside the window: `inkbench tune` in a process of its own. In: a spec and a folder. Out: how far
// it is, the best so far, and what it found.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/workbench/child_process.h"
#include "app/workbench/fit_result.h"

namespace inkbench {

enum class FitState { running, stopping, finished, stopped, failed };

/// One line of a search's progress.
struct FitProgress {
  size_t done = 0, total = 0;  ///< Candidates; `total` is 0 until it is known.
  std::optional<double> best;  ///< The objective; none before something could be drawn.
  std::vector<std::pair<std::string, std::string>> values;  ///< The best ones, as texts of values, by key.
};

/// Nothing for a line that is none.
std::optional<FitProgress> parse_fit_progress(const std::string& line);

class FitRun {
 public:
  /// Starts `program tune spec --out folder`. Errors (work): it cannot be started.
  FitRun(const std::filesystem::path& program, const std::filesystem::path& spec,
         const std::filesystem::path& folder);

  /// Takes in what it tells. Returns whether anything changed.
  bool poll();
  /// It ends after the candidate that it draws and keeps the best so far. A second time, it ends at once.
  void cancel();

  FitState state() const { return state_; }
  bool is_over() const { return state_ >= FitState::finished; }
  /// As it last told.
  const FitProgress& progress() const { return progress_; }

  struct TracePoint {
    size_t done = 0;
    double best = 0;
    bool operator==(const TracePoint&) const = default;
  };
  /// The best objective as the search went on: a point for each line that it told.
  const std::vector<TracePoint>& trace() const { return trace_; }

  /// Once it is over: what it found, of a stopped one the best so far; none where it found nothing.
  const std::optional<FitResult>& result() const { return result_; }
  /// Why it failed.
  const std::string& problem() const { return problem_; }

 private:
  bool listen();
  void note_end();
  void read_result();
  FitResult best_so_far() const;

  std::filesystem::path folder_;
  std::unique_ptr<ChildProcess> process_;
  FitState state_ = FitState::running;
  FitProgress progress_;
  std::vector<TracePoint> trace_;
  std::optional<FitResult> result_;
  std::string problem_;
};

}  // namespace inkbench
