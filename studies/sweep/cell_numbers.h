// The numbers of one cell: its ink, and where the spec asks for them the measures of its lines against the
// reference. Each view gives counts; the counts of all views are added before any ratio is taken.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "pipeline/pipeline.h"
#include "studies/measures/ladder_measures.h"
#include "studies/sweep/spec.h"

namespace inkbench {

/// What one view of a cell adds up to. Pools by addition.
struct CellTally {
  int64_t pixels = 0, inked = 0;  ///< Of the whole image.
  size_t faces = 0;               ///< Triangles of the main model as drawn, in the first view.
  LineTally lines;
  std::array<ShareCounts, kLineClasses.size()> recall;  ///< By class.
  LadderTally ladder;
  InnerTally inner;

  void add(const CellTally& other);
};

class CellMeter {
 public:
  CellMeter(Pipeline& pipeline, const StudySpec& spec);

  /// Draws what the measures need. `view` is the place in the spec's views.
  CellTally tally(const Frame& frame, size_t view);

  /// One text for each of `number_columns`; empty where a measure has no value (a recall over no lines).
  std::vector<std::string> numbers(const CellTally& tally) const;

 private:
  bool wants(std::string_view measure) const;
  void add_ladder(const Settings& settings, size_t view, const LineView& level, CellTally& tally);
  const LineMap& full_drawing(const Frame& full);

  Pipeline& pipeline_;
  const StudySpec& spec_;
  bool wants_lines_ = false, wants_ladder_ = false, wants_inner_ = false;
  std::vector<Stage<LineView>> full_views_;  ///< For each view the full mesh's lines; `drawn` is left empty.
  std::map<Key, LineMap> full_drawings_;     ///< Of the full mesh, for all k's that a sweep comes back to.
};

}  // namespace inkbench
