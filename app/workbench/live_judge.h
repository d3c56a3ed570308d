// Measures the drawn lines beside the window: the newest request wins, and the window never waits. In: edges
// and reference lines as plain data. Out: measures and maps of what is right and wrong.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "app/workbench/background_work.h"
#include "pipeline/base/key.h"
#include "pipeline/lines/reference_lines.h"
#include "studies/measures/match_maps.h"
#include "studies/measures/measures.h"

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
Judgement judge(const JudgeRequest& request, const StopAsked& stop = {});

/// A request in work is finished when a newer one comes: its result is still worth showing.
class LiveJudge : public BackgroundWork<JudgeRequest, Judgement, Key> {
 public:
  explicit LiveJudge(News& news);
};

}  // namespace inkbench
