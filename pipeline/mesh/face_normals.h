// SPDX-License-Identifier: MIT
// The triangles' own planes. In: a mesh. Out: a normal for each triangle.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "pipeline/mesh/mesh.h"

namespace inkbench {

/// F unit vectors in the mesh's space, outwards where the triangle runs counter-clockwise; 0 where it has no
/// area.
std::vector<glm::vec3> face_normals(const Mesh& mesh);

}  // namespace inkbench
