// SPDX-License-Identifier: MIT
// What decimation does to lines (measures.md section 5). In: a level's lines and the full mesh's, from one
// camera. Out: which part of a loss is the geometry's, and how much of the inner drawing stays or is new.
#pragma once

#include <optional>

#include "pipeline/lines/line_map.h"
#include "studies/measures/tally.h"

namespace inkbench {

/// The lines of one mesh in one view; all maps have the same size and are not thinned.
struct LineView {
  LineMap drawn;    ///< By the filter.
  LineMap wanted;   ///< Reference lines of tier 1.
  LineMap allowed;  ///< Reference lines of tier 2.
  LineMap outline;  ///< The silhouette, boundary and object lines among the wanted.
};

/// The counts behind the F's of a level against the full mesh. Pools by addition.
struct LadderTally {
  F1Counts geometry;    ///< The level's wanted lines against the full mesh's.
  F1Counts end_to_end;  ///< The level's drawn lines against the full mesh's.

  void add(const LadderTally& other);
};

/// In both F's a predicted pixel on a line that the full mesh allows is not false. `full.drawn` is not read.
LadderTally tally_against_full(const LineView& level, const LineView& full,
                               double tolerance_px = kTolerancePx);

/// The counts behind `internal_kept` and `internal_new`. Pools by addition.
struct InnerTally {
  ShareCounts kept;   ///< The full mesh's drawn inner pixels that pair with drawn pixels of the level.
  ShareCounts known;  ///< The level's drawn inner pixels that pair with drawn pixels of the full mesh.

  void add(const InnerTally& other);
  /// None where the level draws no inner pixel.
  std::optional<double> new_share() const;
};

/// Drawn pixels are thinned; an inner one is further than twice the tolerance from every outline pixel of its
/// own view.
InnerTally tally_inner(const LineView& level, const LineView& full, double tolerance_px = kTolerancePx);

}  // namespace inkbench
