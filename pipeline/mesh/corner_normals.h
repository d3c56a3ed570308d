// SPDX-License-Identifier: MIT
// Normals corner by corner: smooth across some edges, apart at the others. In: triangles between points. Out:
// a normal for each corner, and the vertices (a point with a normal) that they make.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "pipeline/mesh/mesh.h"
#include "pipeline/mesh/triangle_edges.h"

namespace inkbench {

/// Which edges are smooth: those whose faces differ by less than `below_deg` (180: all, 0: none), or, where
/// there are `groups` (one for each triangle), those between two triangles of one group other than 0.
struct SmoothEdges {
  double below_deg = 180.0;
  std::span<const uint32_t> groups;
};

/// For each corner the angle-weighted mean (Thuermer and Wuethrich 1998) of the faces that hang together
/// around its point across smooth edges. `edges` are `sorted_edges` of the triangles. Where more than two
/// faces meet, each goes with the one that turns least against it, so that the sides of a sheet stay apart;
/// so do faces folded onto each other. A sliver, whose own normal would be rounding, goes with the face
/// across its longest edge. Unit length; +y where no face has an area.
std::vector<glm::vec3> corner_normals(const std::vector<glm::vec3>& points,
                                      const std::vector<Triangle>& triangles,
                                      const std::vector<EdgeUse>& edges, const SmoothEdges& smooth);

/// Makes each pair of a point and a normal a vertex. `mesh.positions` are points. The vertices stand in order
/// of `ranks` (one for each corner; of equal corners the first counts), or of their points where there are
/// none.
void split_vertices(Mesh& mesh, const std::vector<glm::vec3>& normals,
                    const std::vector<uint32_t>& ranks = {});

/// Puts equal positions together and gives the mesh such normals.
void recompute_normals(Mesh& mesh, const SmoothEdges& smooth);

}  // namespace inkbench
