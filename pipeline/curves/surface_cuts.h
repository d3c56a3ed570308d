// SPDX-License-Identifier: MIT
// Where surfaces cut each other. In: two meshes, or one with itself. Out: the cuts as pieces through faces,
// and where edges pierce faces. No view changes them.
#pragma once

#include <glm/mat4x4.hpp>
#include <vector>

#include "pipeline/curves/triangle_tree.h"
#include "pipeline/lines/chain.h"

namespace inkbench {

/// An edge of the first mesh (0) or the second (1) that goes through a face of the other.
struct Piercing {
  int mesh = 0;
  uint32_t edge = 0;
  uint32_t face = 0;
  double along = 0.0;  ///< 0 at the edge's first point, 1 at its second.
  glm::dvec3 at{0.0};  ///< In the first mesh's space.
};

struct SurfaceCuts {
  std::vector<Piercing> piercings;
  std::vector<Link> pieces;  ///< Between piercings; each runs through one face of each mesh.
};

/// A mesh to cut, and which of its edges are lines of their own.
struct CutMesh {
  const TriangleTree* tree = nullptr;
  const std::vector<uint8_t>* drawn_edges = nullptr;  ///< By edge: not 0 for boundaries and creases.
};

/// `second_to_first` leads from the second mesh's space to the first's. The second mesh is moved by a tenth
/// of `TriangleTree::on_plane` in a direction that no mesh has, so that no point lies in a face's plane.
/// Pieces that run along a drawn edge within `on_plane` are left out: there is a line already, and surfaces
/// that only touch have no others. The order depends on the meshes alone.
SurfaceCuts cut_surfaces(const CutMesh& first, const CutMesh& second, const glm::dmat4& second_to_first);

/// Of a mesh with itself. Faces that share a point are not cut with each other.
SurfaceCuts cut_with_itself(const CutMesh& mesh);

}  // namespace inkbench
