// SPDX-License-Identifier: MIT
// Vertex normals from the faces around them. In: a mesh. Out: the same with other normals.
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "pipeline/mesh/mesh.h"

namespace inkbench {

/// In radians, 0 to pi; by atan2, which keeps its precision for tiny and straight angles, where acos of a dot
/// product loses it.
double angle_between(const glm::dvec3& a, const glm::dvec3& b);

/// What a triangle adds to the normals of its three corners: its unit normal times the angle there (Thuermer
/// and Wuethrich 1998); 0 where it has no area.
std::array<glm::dvec3, 3> weighted_normals(const std::array<glm::dvec3, 3>& corners);

/// Replaces the normals by the angle-weighted average of the adjacent face normals (Thuermer and Wuethrich
/// 1998); a vertex without a usable face gets +y.
void smooth_normals(Mesh& mesh);

}  // namespace inkbench
