// SPDX-License-Identifier: MIT
// One cubic through a run of points: Schneider's method (Graphics Gems, 1990): least squares over the
// controls, then the points' parameters moved to where the curve is nearest, a few times over. In: a polyline
// and, where it is to go on smoothly, its end tangents. Out: a curve that is nowhere farther from it than
// asked, or nothing.
#pragma once

#include <optional>
#include <span>

#include "pipeline/vectors/cubic_path.h"

namespace inkbench {

/// A cubic from the first point to the last. `leaving` and `arriving`: unit vectors into the run, in whose
/// direction the controls lie; nothing where they may lie anywhere. Between curve and polyline there is a way
/// to walk along both at once, each forwards, never more than `error` apart: so each point of one is that
/// near to the other. Nothing where none was found. 3 points or more, none repeated.
std::optional<Cubic> fit_cubic(std::span<const glm::dvec2> points, const std::optional<glm::dvec2>& leaving,
                               const std::optional<glm::dvec2>& arriving, double error);

}  // namespace inkbench
