// SPDX-License-Identifier: MIT
// Thinning: lines of any width become lines one pixel wide. In: a line map. Out: its thinned map, on which
// lines are counted and matched.
#pragma once

#include "pipeline/lines/line_map.h"

namespace inkbench {

/// The map thinned to convergence; what lies outside the image counts as background. The result depends on
/// nothing but the map. A pixel that stands alone stays; 8-connected parts stay connected.
/// Source: Guo and Hall, "Parallel thinning with two-subiteration algorithms", CACM 32(3), 1989, algorithm
/// A1, with the conditions G1, G2 and G3 (second sub-iteration: G3') of MATLAB's `bwmorph(..., 'thin', Inf)`.
LineMap thinned(const LineMap& map);

}  // namespace inkbench
