// SPDX-License-Identifier: MIT
// Where outlines turn back on themselves. In: a line along a mesh's edges in a view, the faces around its
// points. Out: its cusps marked.
#pragma once

#include "pipeline/curves/curve_source.h"
#include "pipeline/curves/view_lines.h"

namespace inkbench {

/// Marks the points at which another number of the faces around them lies before the one step than before the
/// other: where faces fold over in the image beside a silhouette or boundary. `to_world` is the model's.
void mark_cusps(const CurveSource& source, const glm::dmat4& to_world, const CurveView& view, ViewLine& line);

}  // namespace inkbench
