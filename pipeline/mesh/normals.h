// SPDX-License-Identifier: MIT
// Vertex normals from the faces around them. In: a mesh. Out: the same with other normals.
#pragma once

#include "pipeline/mesh/mesh.h"

namespace inkbench {

/// In radians, 0 to pi; by atan2, which keeps its precision for tiny and straight angles, where acos of a dot
/// product loses it.
double angle_between(const glm::dvec3& a, const glm::dvec3& b);

/// Replaces the normals by the angle-weighted average of the adjacent face normals (Thuermer and Wuethrich
/// 1998); a vertex without a usable face gets +y.
void smooth_normals(Mesh& mesh);

}  // namespace inkbench
