// SPDX-License-Identifier: MIT
// The formulas of the measures (docs/measures.md). In: a drawing's tally. Out: the value; none where the
// measure has none.
#pragma once

#include <optional>

#include "studies/measures/drawing_tally.h"

namespace inkbench {

using MeasureValue = std::optional<double>;

MeasureValue precision_of(const DrawingTally& tally);
MeasureValue recall_of(const DrawingTally& tally);
/// Mean of both directions' truncated distances.
MeasureValue chamfer_of(const DrawingTally& tally);
/// None where lines are infinitely far from the other side's, which has none.
MeasureValue hd95_of(const DrawingTally& tally);
MeasureValue baddeley_of(const DrawingTally& tally);
MeasureValue breaks_of(const DrawingTally& tally);
MeasureValue mean_gap_of(const DrawingTally& tally);
MeasureValue ends_of(const DrawingTally& tally);
MeasureValue thickness_of(const DrawingTally& tally);
MeasureValue thickness_variation_of(const DrawingTally& tally);
/// None without polylines that have ink beside them.
MeasureValue jaggedness_of(const DrawingTally& tally);
MeasureValue bias_of(const DrawingTally& tally);
MeasureValue ink_share_of(const DrawingTally& tally);
/// The F of the whole drawing with these matchings.
MeasureValue f1_with(const DrawingTally& tally, const MatchCounts& matches);

}  // namespace inkbench
