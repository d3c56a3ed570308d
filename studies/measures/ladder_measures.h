// What decimation does to lines (measures.md section 5). In: a level's lines and the full mesh's, from one
// camera. Out: which part of a loss is the geometry's, and how much of the inner drawing stays or is new.
#pragma once

#include <optional>

#include "studies/measures/line_map.h"
#include "studies/measures/tally.h"

namespace inkbench {

/// The lines of one mesh in one view; all maps have the same size and are not thinned.
struct LineView {
  LineMap drawn;    ///< By the filter.
  LineMap wanted;   ///< Reference lines of tier 1.
  LineMap allowed;  ///< Reference lines of tier 2.
  LineMap outline;  ///< The silhouette, boundary and object lines among the wanted.
};

struct LadderMeasures {
  double f1_geometry = 0;    ///< The level's wanted lines against the full mesh's.
  double f1_end_to_end = 0;  ///< The level's drawn lines against the full mesh's.
  /// Share of the full mesh's drawn inner pixels that pair with drawn pixels of the level. None without inner
  /// pixels.
  std::optional<double> internal_kept;
  /// Share of the level's drawn inner pixels that pair with no drawn pixel of the full mesh. None as above.
  std::optional<double> internal_new;
};

/// Drawn pixels are thinned; an inner one is further than twice the tolerance from every outline pixel of its
/// own view. In both F's a predicted pixel on a line that the full mesh allows is not false.
LadderMeasures measure_against_full(const LineView& level, const LineView& full,
                                    double tolerance_px = kTolerancePx);

}  // namespace inkbench
