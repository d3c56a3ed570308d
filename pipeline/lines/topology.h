// SPDX-License-Identifier: MIT
// Which faces meet along which edge. In: a mesh. Out: its welded points, faces with normals, and edges with
// their faces. View-independent: made once for each mesh, then read for every view.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "pipeline/mesh/mesh.h"

namespace inkbench {

/// Points at exactly the same position are one. Faces that name one point twice afterwards are left out, and
/// so are repetitions of a face (the same points in the same turn). A face with three points on one line
/// stays, since leaving it out would open its neighbours' edges; it takes the normal of the face across its
/// longest edge, onto which it collapses.
struct MeshTopology {
  struct Edge {
    std::array<uint32_t, 2> points;  ///< The smaller index first.
    uint32_t first_use = 0;          ///< Into `uses`.
    uint32_t use_count = 0;          ///< 1: boundary. 2: manifold. More: non-manifold.
  };
  struct Use {
    uint32_t face = 0;
    bool forward = true;  ///< The face runs from the edge's first point to its second.
  };

  std::vector<glm::dvec3> positions;           ///< In the mesh's own units; only points that faces use.
  std::vector<std::array<uint32_t, 3>> faces;  ///< Counter-clockwise from outside.
  std::vector<glm::dvec3> normals;             ///< Of unit length, one for each face; 0 where it has none.
  std::vector<Edge> edges;                     ///< Sorted by their points.
  std::vector<Use> uses;                       ///< Grouped by edge; within an edge in order of faces.
  std::vector<double> cover_angles_deg;        ///< For each edge, see `cover_angles`.
  std::vector<std::array<uint32_t, 3>> face_edges;  ///< Edge from corner i to corner i + 1.

  std::span<const Use> uses_of(const Edge& edge) const {
    return {uses.data() + edge.first_use, edge.use_count};
  }
};

/// Time and memory in proportion to the mesh.
MeshTopology make_topology(const Mesh& mesh);

/// Whether two uses of an edge run against each other, as on a surface with consistent faces.
inline bool consistent(const MeshTopology::Use& a, const MeshTopology::Use& b) {
  return a.forward != b.forward;
}

}  // namespace inkbench
