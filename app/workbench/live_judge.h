// SPDX-License-Identifier: MIT
// Measures the drawn lines beside the window: the newest request wins, and the window never waits. In: edges
// and reference lines as plain data. Out: measures and maps of what is right and wrong.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "app/workbench/background_work.h"
#include "pipeline/base/key.h"
#include "pipeline/lines/reference_lines.h"
#include "studies/measures/match_maps.h"
#include "studies/measures/measures.h"

namespace inkbench {

/// One view: raw `lines` (H x W x 1) and the reference lines of the same size. Shared, since both
/// live through many requests; nobody may change them.
struct JudgedView {
  std::shared_ptr<const Image> edges;
  std::shared_ptr<const ReferenceLines> lines;
};

struct JudgeRequest {
  uint64_t id = 0;  ///< Comes back with the result.
  JudgedView view;
  JudgedView full;  ///< The same with the full mesh, for a level of it; may be empty.
  JudgeParams judge;
};

struct Judgement {
  uint64_t id = 0;
  std::string error;   ///< Why there is nothing else; "" as a rule.
  DrawingTally tally;  ///< Without faces, and without a ladder where no full mesh was given.
  MatchMaps maps;
  double seconds = 0;  ///< That it took.
};

/// What the worker does, on the calling thread. Stops early, with an unfinished result, once `stop` says so.
/// Errors (input): sizes that differ, a tolerance out of range, a missing part.
Judgement judge(const JudgeRequest& request, const StopAsked& stop = {});

/// Whether the measure is one of what the window looks at: neither the scene's nor causes nor curves, and of
/// a level only those that need the full mesh.
bool is_judged(const Measure& measure, const DrawingTally& tally);

/// A request in work is finished when a newer one comes: its result is still worth showing.
class LiveJudge : public BackgroundWork<JudgeRequest, Judgement, Key> {
 public:
  explicit LiveJudge(News& news);
};

}  // namespace inkbench
