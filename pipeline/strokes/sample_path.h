// SPDX-License-Identifier: MIT
// Points as a stroke needs them. In: a path of any points. Out: the same path by points at even steps, closer
// where it bends.
#pragma once

#include "pipeline/strokes/stroke_path.h"

namespace inkbench {

/// How far a path may be from what it is a sample of.
inline constexpr float kSampleErrorPx = 0.05F;

/// Steps of at most `longest_px`, as long as the way between them is straight to `kSampleErrorPx`. Points
/// where the class changes stay. `along_px` is as before.
StrokePath sampled(const StrokePath& path, float longest_px);

/// Goes on straight beyond both ends, but not where the view ends; a closed path has none.
void overshoot(StrokePath& path, float by_px);

}  // namespace inkbench
