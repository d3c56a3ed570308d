// Measures the drawn lines beside the window: the newest request wins, and the window never waits. In: edges
// and reference lines as plain data. Out: measures and maps of what is right and wrong.
#pragma once

#include <array>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "studies/measures/match_maps.h"
#include "studies/measures/measures.h"
#include "studies/reference/reference_lines.h"

namespace inkbench {

/// One view: raw `combined_edges` (H x W x 1) and the reference lines of the same size. Shared, since both
/// live through many requests; nobody may change them.
struct JudgedView {
  std::shared_ptr<const Image> edges;
  std::shared_ptr<const ReferenceLines> lines;
};

struct JudgeRequest {
  uint64_t id = 0;  ///< Comes back with the result.
  JudgedView view;
  JudgedView full;  ///< The same with the full mesh, for a level of it; may be empty.
  double tolerance_px = kTolerancePx;
};

struct Judgement {
  uint64_t id = 0;
  std::string error;  ///< Why there is nothing else; "" as a rule.
  Measures measures;
  std::array<std::optional<double>, kLineClasses.size()>
      recall;                            ///< By class; none where the view has no such line.
  std::optional<LadderMeasures> ladder;  ///< Where the request had a full mesh.
  MatchMaps maps;
  double seconds = 0;  ///< That it took.
};

/// What the worker does, on the calling thread. Stops early, with an unfinished result, once `stop` says so.
/// Errors (input): sizes that differ, a tolerance out of range, a missing part.
Judgement judge(const JudgeRequest& request, const std::function<bool()>& stop = {});

class LiveJudge {
 public:
  /// `on_done` is called on the worker's thread after each result: to wake a window that sleeps.
  explicit LiveJudge(std::function<void()> on_done = {});
  LiveJudge(const LiveJudge&) = delete;
  LiveJudge& operator=(const LiveJudge&) = delete;
  /// Forgets what waits and waits only for the step in work.
  ~LiveJudge();

  /// Replaces a request that still waits. The one in work goes on: its result is still worth showing.
  void submit(JudgeRequest request);

  /// The newest result, once; nothing where there is no new one.
  std::optional<Judgement> poll();

  /// Whether a request waits or is in work.
  bool is_busy() const;

 private:
  void serve();
  bool is_closing() const;

  std::function<void()> on_done_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<JudgeRequest> waiting_;
  std::optional<Judgement> result_;
  bool working_ = false;
  bool closing_ = false;
  std::thread thread_;  ///< Last, so that it starts when all else is there.
};

}  // namespace inkbench
