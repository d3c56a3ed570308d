// SPDX-License-Identifier: MIT
// An even course. In: a path. Out: the same one, smoothed along its arc length.
#pragma once

#include <span>
#include <vector>

#include "pipeline/strokes/stroke_path.h"

namespace inkbench {

/// By a Gaussian of that standard deviation in px, a point every pixel or closer. Ends stay where they are;
/// a closed path has none. Neutral: 0.
StrokePath smoothed(const StrokePath& path, float deviation_px);

/// Values at the points of a path, smoothed in the same way; those near an end weigh what is there alone.
std::vector<float> smoothed_values(std::span<const float> values, const StrokePath& path, float deviation_px);

}  // namespace inkbench
