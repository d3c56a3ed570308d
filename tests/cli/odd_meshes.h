// SPDX-License-Identifier: MIT
// Meshes that are no clean closed surface, as files' content: what people load all the same.
#pragma once

#include <string>
#include <vector>

#include "pipeline/mesh/mesh.h"

namespace inkbench {

struct OddMesh {
  std::string name;     ///< Of the file, with its extension.
  std::string content;  ///< Of the file.
  size_t faces = 0;     ///< That can be drawn; 0 where none can.
  std::string note;     ///< What the program must say of it; "" for nothing.
};

/// Boundaries, many parts, non-manifold edges and points, rounded STL corners, faces without area, one
/// triangle, coincident faces, NaN, faces turned inside out or at random.
std::vector<OddMesh> odd_meshes();

/// Only faces that cannot be drawn.
std::vector<OddMesh> hopeless_meshes();

/// As OBJ, without normals.
std::string obj_of(const Mesh& mesh);

}  // namespace inkbench
