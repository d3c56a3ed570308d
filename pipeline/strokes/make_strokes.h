// SPDX-License-Identifier: MIT
// Curves to strokes: the whole way of a stroke style, but for the paint. In: a view's curves, the style, what
// of the view widths follow, the strokes of the frame before. Out: strokes as they are drawn.
#pragma once

#include "pipeline/strokes/stroke_widths.h"

namespace inkbench {

/// Curves that go on in each other become one path (join_curves.h, merge_overlaps.h), gaps are bridged, short
/// paths dropped,
/// what is left is smoothed and sampled; then each path is drawn `passes` times, with its widths and its
/// wobble, and what is covered is cut into dashes. Strokes without width are left out. Covered ones come
/// first. With `before` and `stroke.coherent` a stroke goes on with the paint that it had (carry_along.h).
/// Deterministic. Errors (input): `stroke.profile` is none.
Strokes make_strokes(const Curves& curves, const StrokeParams& params, const StrokeClasses& classes,
                     const StrokeSurroundings& around, const Strokes* before = nullptr);

}  // namespace inkbench
