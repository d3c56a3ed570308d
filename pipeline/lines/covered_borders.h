// SPDX-License-Identifier: MIT
// Borders that only the triangulation has: where one face's edge runs along several edges of its neighbours
// (T-junctions), or lies beside its neighbour's by rounding. In: topology. Out: which borders others cover.
#pragma once

#include <vector>

#include "pipeline/lines/topology.h"

namespace inkbench {

/// Of a border that no others cover.
inline constexpr double kUncovered = 360.0;

/// For each edge: of one with one face, the smallest angle in degrees so that other such edges, of faces that
/// differ from its own by no more, cover it from end to end within a millionth of the bounding box's
/// diagonal; else `kUncovered`.
std::vector<double> cover_angles(const MeshTopology& topology);

}  // namespace inkbench
