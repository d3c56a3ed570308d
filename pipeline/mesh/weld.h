// SPDX-License-Identifier: MIT
// Vertices at one place made one. In: a mesh whose files or primitives repeat points (an STL's corners, a
// box's sharp edges). Out: the mesh without the repetitions, or which vertices coincide.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "pipeline/mesh/mesh.h"

namespace inkbench {

struct WeldResult {
  Mesh mesh;
  size_t merged_vertices = 0;    ///< Vertices that went into an earlier one.
  size_t dropped_triangles = 0;  ///< Triangles that named one vertex twice afterwards.
};

/// Merges each vertex into the first one within `tolerance` (in the file's units, 0 or more; 0: only equal
/// positions) that was not merged itself, so that merging never creeps along a chain. A merged vertex keeps
/// its first position; its normal becomes the mean. Counts are added to the notes. Errors (input): a
/// tolerance that is negative or not finite.
WeldResult weld(const Mesh& mesh, float tolerance);

/// For each position the first one within `tolerance` (above 0) that has no such first one itself. A position
/// that is not finite is its own.
std::vector<uint32_t> first_within(const std::vector<glm::vec3>& positions, double tolerance);

/// For each vertex the first one at exactly the same position (itself, mostly).
std::vector<uint32_t> first_at_same_position(const std::vector<glm::vec3>& positions);

}  // namespace inkbench
