// SPDX-License-Identifier: MIT
// A stroke of a style by itself, to look at while the style is edited.
#pragma once

#include "pipeline/settings/settings.h"
#include "pipeline/strokes/stroke.h"

namespace inkbench {

/// A visible silhouette from the left to the right of a rectangle, in a slight bend, stroked with the
/// settings' style where no scene is: widths that follow light and distance are as they are near and lit.
/// Errors (input): as `make_strokes`.
Strokes sample_stroke(const Settings& settings, float width_px, float height_px);

}  // namespace inkbench
