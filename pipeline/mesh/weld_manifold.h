// SPDX-License-Identifier: MIT
// A mesh's triangles cut into two-manifold pieces, as half-edge structures need them. In: any mesh. Out: for
// each triangle its corners as points of those pieces. Pure: no OpenMesh.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "pipeline/mesh/mesh.h"

namespace inkbench {

struct ManifoldPieces {
  /// Stands in `corners` for a triangle that no piece holds.
  static constexpr uint32_t kLeftOut = std::numeric_limits<uint32_t>::max();

  std::vector<std::array<uint32_t, 3>> corners;  ///< For each triangle of the mesh: points, or `kLeftOut`.
  std::vector<uint32_t> origin;                  ///< For each point a vertex of the mesh at its place.
  std::vector<bool> is_cut;                      ///< For each point: it lies on a cut between pieces.
  std::vector<uint32_t> next_equal;  ///< For each vertex of the mesh the next at its position, in a ring.
  size_t triangles = 0;              ///< Triangles that a piece holds.
};

/// Equal positions become one point first. Left out are triangles that name a position twice and triangles
/// that repeat another one's three positions in the same sense (in the opposite sense they are a back side, a
/// piece of its own). Pieces are cut apart where an edge joins more than two triangles, or two of different
/// orientation, and where surfaces touch in one point only. Afterwards each directed edge belongs to one
/// triangle and the triangles around each point form one fan.
ManifoldPieces cut_to_manifold(const Mesh& mesh);

}  // namespace inkbench
