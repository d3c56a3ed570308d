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
/// them, in the classes' colours. Covered ones lie fainter and dashed in the group `hidden`, where they are
/// asked for; each says in `data-covered` by how many surfaces. `below`: elements under the curves.
std::string curves_svg(const Curves& curves, bool with_hidden, const StrokeClasses& classes,
                       const VectorPage& page, const std::string& below = "");

}  // namespace inkbench
