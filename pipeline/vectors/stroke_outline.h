// SPDX-License-Identifier: MIT
// Strokes as areas: what their discs cover. In: parts of strokes. Out: the outline of their union.
#pragma once

#include <span>

#include "pipeline/strokes/stroke.h"
#include "pipeline/vectors/outline.h"

namespace inkbench {

/// Steps of a stroke: that from point `first` to `first` + 1, ..., that from `last` - 1 to `last`.
struct StrokePart {
  const Stroke* stroke = nullptr;
  size_t first = 0, last = 0;
};

StrokePart whole(const Stroke& stroke);

/// What the parts cover together, each place once; round parts of it are polygons that lie at most
/// `kArcError` px inside.
Outline stroke_outline(std::span<const StrokePart> parts);

inline constexpr double kArcError = 0.01;

}  // namespace inkbench
