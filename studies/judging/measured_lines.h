// SPDX-License-Identifier: MIT
// From drawn lines and their reference lines to what the measures compare. In: raw `lines`, reference lines,
// the judge. Out: line maps and tallies, the same for a study's cell, the window and the
// command line.
#pragma once

#include "pipeline/base/stop.h"
#include "pipeline/lines/reference_lines.h"
#include "studies/measures/measures.h"

namespace inkbench {

/// The drawn lines with the reference lines of the same view and size.
LineView line_view(const LineMap& drawn, const ReferenceLines& lines, const JudgeParams& judge);

/// What is known of one view.
struct KnownView {
  const LineView& view;  ///< Where no reference lines were found, `drawn` alone.
  const ReferenceLines* lines = nullptr;
  const LineView* full = nullptr;  ///< The full mesh's, with `drawn` for inner lines.
};

/// What the needs ask for and the view knows; `faces` is left to the caller. Straightness is measured along
/// tier 1 without `object` lines, which are staircases along pixels. Once `stop` says so the rest is left
/// out.
DrawingTally tally_view(const KnownView& known, const JudgeParams& judge, const MeasureNeeds& needs,
                        const StopAsked& stop = {});

}  // namespace inkbench
