// SPDX-License-Identifier: MIT
// Which side of a surface is its outside. In: triangles between points, as files turn them. Out: those that
// are to be turned over, so that neighbours agree, and what was found.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "pipeline/mesh/triangle_edges.h"

namespace inkbench {

struct Orientation {
  std::vector<bool> is_turned;   ///< For each triangle; empty where none is.
  size_t mended = 0;             ///< Turned since they lay against their neighbours.
  size_t turned_to_normals = 0;  ///< Turned to the side that the file's normals show.
  size_t turned_outwards = 0;
  size_t one_sided_parts =
      0;  ///< Parts that have no two sides, as a Moebius strip has none; left as they are.
  size_t inside_out_parts = 0;  ///< Closed, and left with their faces inwards.
};

/// Parts hang together across edges of two triangles. Within a part that can have two sides all triangles get
/// one sense: that of the file's normals where there are `votes` (for each triangle its area, negative where
/// its normals oppose it, 0 where it has none); else, where the part was mixed, outwards if it is closed and
/// that of the larger area if not; else its own. With `outwards`, closed parts face outwards in any case.
Orientation find_orientation(const std::vector<glm::vec3>& points, const std::vector<Triangle>& triangles,
                             const std::vector<EdgeUse>& edges, const std::vector<double>& votes,
                             bool outwards);

}  // namespace inkbench
