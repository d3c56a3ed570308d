// SPDX-License-Identifier: MIT
// Gaps that a hand would draw over. In: paths, and how long a gap may be. Out: fewer paths.
#pragma once

#include <vector>

#include "pipeline/strokes/stroke_path.h"

namespace inkbench {

/// Joins ends that lie at most `longest_px` apart where both paths go on in one another's direction, by 45
/// degrees at most, those that fit best first; both of one object (or traced), and both hidden or both not.
/// A path whose own ends fit becomes closed. What is drawn over a gap goes on in both directions and has no
/// places.
std::vector<StrokePath> bridge_gaps(const std::vector<StrokePath>& paths, float longest_px);

}  // namespace inkbench
