// SPDX-License-Identifier: MIT
// How a strength map fares against drawings of the same image, threshold by threshold. In: the map, the
// drawings, a tolerance. Out: counts, which pool by addition before any ratio is taken.
#pragma once

#include <array>
#include <span>

#include "pipeline/base/stop.h"
#include "pipeline/lines/tiered_lines.h"
#include "studies/measures/strength_levels.h"

namespace inkbench {

/// At one threshold.
struct StrengthCounts {
  int64_t predicted = 0;   ///< Pixels of the thinned prediction.
  int64_t right = 0;       ///< Of these, those that pair with a pixel of any drawing.
  int64_t referenced = 0;  ///< Pixels of all thinned drawings.
  int64_t found = 0;       ///< Of these, those that pair with a pixel of the prediction.

  void add(const StrengthCounts& other);
  bool operator==(const StrengthCounts&) const = default;
};

/// By threshold, the lowest first.
using CurveCounts = std::array<StrengthCounts, kThresholds>;

void add_counts(CurveCounts& sum, const CurveCounts& other);

/// Cuts, thins and matches at each threshold, exactly. `drawings` are those of several annotators, not
/// thinned; borders are ignored. A predicted pixel is right if it pairs in any of them, where of the maximum
/// matchings the nearest one counts (`NearMatching`); to pair with what is allowed is right, too, and finds
/// nothing. All have the map's size. Throws `Stopped`.
CurveCounts count_strengths(const StrengthLevels& levels, std::span<const TieredLines> drawings,
                            double tolerance_px, const StopAsked& stop = {});

}  // namespace inkbench
