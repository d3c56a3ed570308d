// SPDX-License-Identifier: MIT
// Decimation by OpenMesh with quadrics, once per mesh and down to its minimum. In: a mesh, however defective.
// Out: the record of its collapses, from which `mesh_at_level` makes any face count.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "pipeline/base/stop.h"
#include "pipeline/mesh/levels/collapse_record.h"
#include "pipeline/mesh/mesh.h"

namespace inkbench {

/// Decimates by half-edge collapses in the order of their quadric error (Garland and Heckbert 1997), with
/// these promises at every level: vertices are original vertices; no collapse turns a face by more than the
/// angle of `kMaxTurnCosine` against what it was before, nor away from the original surface that it stands
/// for, nor folds it onto a neighbour (150 degrees or more between them); closed pieces stay closed and of
/// their topology; an open boundary's points stay on it, and it stays within `kBoundaryShift` of the bounding
/// box's diagonal of where it was; where pieces meet that are not manifold together, nothing moves. The same
/// mesh gives the same record. Throws `Stopped` soon after `stop` says so.
CollapseRecord record_collapses(const Mesh& mesh, const StopAsked& stop = {});

/// Cosine of the largest turn of a face in one collapse: 75 degrees.
inline constexpr double kMaxTurnCosine = 0.2588;
inline constexpr double kBoundaryShift = 0.01;

/// Which rules a direct decimation follows, for comparison.
enum class DecimationRules {
  ours,             ///< Those of `record_collapses`.
  quadrics,         ///< OpenMesh's `DecimaterT` with its `ModQuadricT` alone.
  quadrics_no_flip  ///< And with its `ModNormalFlippingT`.
};

/// Decimates once to at most `faces` triangles (or as far as it comes) and reads the result off OpenMesh's
/// half-edges: what tests and benchmarks compare with. Triangles over the points of `cut_to_manifold`.
std::vector<std::array<uint32_t, 3>> decimate_directly(const Mesh& mesh, size_t faces, DecimationRules rules);

}  // namespace inkbench
