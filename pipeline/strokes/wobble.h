// SPDX-License-Identifier: MIT
// An unsteady hand. In: a path, how far and over which length it strays. Out: how far its points are moved.
#pragma once

#include <vector>

#include "pipeline/settings/stroke_params.h"
#include "pipeline/strokes/stroke_path.h"

namespace inkbench {

/// For each point of the path, px. By `wobble` and, from the second pass on, by `spread`: each component is
/// at most their sum. What moves a point hangs on its `along_px` and the stroke's number alone, so that it
/// stays where it is on the line while the view turns; a closed path stays closed.
std::vector<glm::vec2> strayed(const StrokePath& path, const StrokeParams& params, int pass);

/// The longest steps between points with which a path can follow its wobble.
float longest_step_px(const StrokeParams& params);

}  // namespace inkbench
