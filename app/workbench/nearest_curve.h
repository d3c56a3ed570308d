// SPDX-License-Identifier: MIT
// Which curve a person points at. In: curves, a point in their pixel space. Out: the nearest one.
#pragma once

#include <cstddef>
#include <optional>

#include "pipeline/curves/curve.h"

namespace inkbench {

/// The place in `curves.curves` of the curve that comes nearest to the point, no farther than `radius_px`,
/// edge included; covered curves only `with_hidden`. Of equally near ones the first visible one, else the
/// first.
std::optional<size_t> nearest_curve(const Curves& curves, glm::vec2 point, float radius_px, bool with_hidden);

}  // namespace inkbench
