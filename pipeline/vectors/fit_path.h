// SPDX-License-Identifier: MIT
// Polylines as few cubic Bezier curves and lines, with a stated error: corners are kept, and between them
// each curve goes as far as the error allows. In: points. Out: a path.
#pragma once

#include <span>

#include "pipeline/vectors/cubic_path.h"
#include "pipeline/vectors/outline.h"

namespace inkbench {

struct FitOptions {
  double error = 0.05;        ///< How far path and polyline are apart at most, in the points' unit.
  double corner_deg = 40.0;   ///< What turns more is a corner, where the path may bend.
  double line_share = 0.25;   ///< What goes from corner to corner within that share of the error is a line.
  double corner_reach = 1.0;  ///< Over which length before and after a point its turn is looked at.
};

/// The path runs through the polyline's ends and corners; each of its points is within `error` of the
/// polyline, and the other way round. Where the last point is the first one, it is closed, and smooth there
/// unless that is a corner. Without pieces where all points are one. The same points give the same path.
CubicPath fit_path(std::span<const glm::dvec2> points, const FitOptions& options);
CubicPath fit_path(std::span<const glm::vec2> points, const FitOptions& options);

/// A closed path for each ring; rings that come to nothing are left out.
std::vector<CubicPath> fit_outline(const Outline& outline, const FitOptions& options);

}  // namespace inkbench
