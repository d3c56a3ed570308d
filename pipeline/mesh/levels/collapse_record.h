// SPDX-License-Identifier: MIT
// What a decimation did, step by step, so that every face count is a replay of a prefix. In: a mesh and the
// record of its collapses (`record_collapses` makes it). Out: the mesh at any face count, in milliseconds.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "pipeline/mesh/mesh.h"

namespace inkbench {

/// One half-edge collapse: the point `removed` goes where `kept` is.
struct Collapse {
  uint32_t removed = 0;
  uint32_t kept = 0;
  bool operator==(const Collapse&) const = default;
};

/// Speaks of points: equal positions of the mesh are one, and non-manifold places are cut apart
/// (`cut_to_manifold`). With V vertices and F triangles it takes about 4 V + 20 F bytes.
struct CollapseRecord {
  static constexpr uint32_t kLeftOut = std::numeric_limits<uint32_t>::max();

  std::vector<std::array<uint32_t, 3>>
      corners;  ///< For each triangle of the mesh its points; three times `kLeftOut` where it is in no level.
  std::vector<uint32_t> origin;      ///< For each point a vertex of the mesh at its place.
  std::vector<uint32_t> next_equal;  ///< For each vertex of the mesh the next at its position, in a ring.
  std::vector<Collapse> collapses;   ///< In order; a removed point occurs in no later one.
  std::vector<uint32_t> faces;  ///< Triangles after 0, 1, 2, ... collapses: falling, one more than collapses.

  bool operator==(const CollapseRecord&) const = default;
};

/// How many collapses lead to the level for an asked count: the most faces that are not more than asked, or
/// the fewest that the record reaches.
size_t collapses_for(const CollapseRecord& record, size_t asked_faces);

/// The mesh with at most `asked_faces` triangles, as near as the record allows: exact or one less, or the
/// record's last level where asked for fewer. `mesh` itself where it has no more than asked, or asked for 0.
/// Vertices are vertices of `mesh` with their positions and normals; where several of its vertices share a
/// place (a sharp edge), each triangle takes the one whose normal fits it best. A note says when the count
/// could not be reached. `record` must be of this mesh.
Mesh mesh_at_level(const Mesh& mesh, const CollapseRecord& record, size_t asked_faces);

/// Is this a record of `mesh`: every size, index, position, the order of collapses, and the first and last
/// face count? What passes can be replayed without harm, wherever it came from.
bool is_record_of(const CollapseRecord& record, const Mesh& mesh);

}  // namespace inkbench
