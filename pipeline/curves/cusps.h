// SPDX-License-Identifier: MIT
// Where outlines turn back on themselves. In: the lines of a view, the faces around their points. Out: the
// same with their cusps marked.
#pragma once

#include <span>
#include <vector>

#include "pipeline/curves/covering.h"

namespace inkbench {

/// Marks, on lines that cover, the points at which another number of the faces around them lies before the
/// one step than before the other: where faces fold over in the image beside a silhouette or boundary.
void mark_cusps(std::span<const CurveModel> models, const CurveView& view, std::vector<ViewLine>& lines);

}  // namespace inkbench
