// SPDX-License-Identifier: MIT
// Covered strokes as dashes. In: a stroke. Out: its dashes, each a stroke.
#pragma once

#include <vector>

#include "pipeline/strokes/stroke.h"

namespace inkbench {

/// Dashes of `dash_px`, round ends included, with `gap_px` between them, where `along_px` says: a dash begins
/// at each multiple of both. One that is wider than long is a dot. No gap: the stroke as it is.
std::vector<Stroke> dashes_of(const Stroke& stroke, float dash_px, float gap_px);

}  // namespace inkbench
