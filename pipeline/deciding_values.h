// SPDX-License-Identifier: MIT
// What would draw a pixel that is no line, and what would remove one that is: the nearest value of each
// parameter that decides it. In: the detector's maps. Out: values, each found by explaining the pixel again.
#pragma once

#include "pipeline/passes/edges/edge_detector.h"

namespace inkbench {

/// For each of the detector's parameters the value nearest to the present one with which the pixel (x, y) of
/// `maps` is a line if it is none, and none if it is one; none where no value within the limits does that
/// alone. Numbers are rounded to three digits beyond the value at which it changes, and by `slack` (a share)
/// beyond it: what the drawn strength and the explained one differ by. Left out are numbers over a thousand
/// times off, which draw rounding, and switches that remove lines: they remove all. As
/// `EdgeDetector::explain` takes its arguments.
std::vector<ExplainedChange> deciding_values(const EdgeDetector& detector, const PerBuffer<Image>& maps,
                                             const Settings& settings, int x, int y, double slack = 0);

}  // namespace inkbench
