// SPDX-License-Identifier: MIT
// Editing a stroke's width along its course by hand. Pure functions: a profile in, a profile out, as
// `parse_profile` gives it and wants it. While dragging, apply them to the profile as it was when the drag
// began, so that going back undoes. Places and shares are rounded to a thousandth.
#pragma once

#include <cstddef>
#include <span>

#include "pipeline/strokes/stroke_widths.h"

namespace inkbench {

/// A new point with that share; one at the same place is moved to it.
WidthProfile with_point(const WidthProfile& profile, const ProfilePoint& point);

/// Moves a point, not past its neighbours; both components are clamped to 0 to 1. `index` is below the
/// number of points.
WidthProfile move_point(const WidthProfile& profile, size_t index, const ProfilePoint& to);

/// Without points the whole width is left everywhere. `index` is below the number of points.
WidthProfile remove_point(const WidthProfile& profile, size_t index);

/// What of the profile a free line was drawn over follows the line, with as few points as stay within
/// `tolerance` (a share) of it; the rest stays, but for a short way on both sides. `drawn`: in the order in
/// which it was drawn, to and fro as the hand went: what was drawn last counts. Fewer than two places along
/// change nothing.
WidthProfile drawn_over(const WidthProfile& profile, std::span<const ProfilePoint> drawn, float tolerance);

}  // namespace inkbench
