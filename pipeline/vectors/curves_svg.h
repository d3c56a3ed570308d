// SPDX-License-Identifier: MIT
// Curves as an SVG file of lines. In: curves and the classes' colours. Out: the file's text.
#pragma once

#include <string>

#include "pipeline/curves/curve.h"
#include "pipeline/settings/stroke_params.h"
#include "pipeline/vectors/svg_page.h"

namespace inkbench {

/// How far a path of the file is from its curve at most.
inline constexpr double kCurveErrorPx = 0.11;

/// One path for each curve, in groups by class and object (`class_groups`), as the buffer `curves` shows
/// them: 1.5 px wide, in the classes' colours. Covered ones, fainter and dashed, in the group `hidden`, only
/// with `stroke.hidden`; each says in `data-covered` by how many surfaces. `below`: elements under the
/// curves.
std::string curves_svg(const Curves& curves, const StrokeParams& stroke, const StrokeClasses& classes,
                       const VectorPage& page, const std::string& below = "");

}  // namespace inkbench
