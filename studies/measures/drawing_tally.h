// SPDX-License-Identifier: MIT
// What a whole drawing adds up to, over all of its views: the counts from which every measure follows. In:
// the tallies of views. Out: their sum.
#pragma once

#include <array>
#include <optional>

#include "pipeline/lines/lines.h"
#include "studies/measures/antialiasing.h"
#include "studies/measures/causes.h"
#include "studies/measures/flicker_tally.h"
#include "studies/measures/ladder_tally.h"
#include "studies/measures/marks.h"
#include "studies/measures/strength_curve.h"
#include "studies/measures/stroke_tally.h"
#include "studies/measures/tally.h"

namespace inkbench {

/// Pools by addition. What was not asked for is empty.
struct DrawingTally {
  int64_t pixels = 0, ink = 0;  ///< Of the whole image, its border included.
  size_t faces = 0;             ///< Triangles of the main model as drawn, in the first view.
  LineTally lines;
  std::array<ShareCounts, kLineClasses.size()> recall;  ///< By class.
  std::optional<LadderTally> ladder;                    ///< Against the full mesh.
  std::optional<InnerTally> inner;
  std::optional<CauseCounts> causes;              ///< Of the false and the missed pixels.
  std::optional<AntialiasingTally> antialiasing;  ///< Of placed lines.
  std::optional<StrengthCurve> strengths;         ///< The detector's, each view a picture.
  std::optional<FlickerTally> flicker;            ///< Between the frames of a path.
  std::optional<StrokeTally> strokes;             ///< Of strokes between the frames of a path.
  std::optional<MarkTally> marks;                 ///< Of what a person marked.

  void add(const DrawingTally& other);
};

/// Of line maps alone: ink and lines.
DrawingTally tally_maps(const LinesToMeasure& lines);

}  // namespace inkbench
