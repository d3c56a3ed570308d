// SPDX-License-Identifier: MIT
// The smooth parts of a mesh with their curvature. In: topology. Out: points, normals and curvature tensors,
// smoothed. View-independent; lines of tier 2 are read from it.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "pipeline/lines/topology.h"

namespace inkbench {

/// A symmetric 3 x 3 matrix: xx, xy, xz, yy, yz, zz. As a curvature tensor it maps a direction along the
/// surface to the change of the normal: positive where the surface is convex.
using SymmetricTensor = std::array<double, 6>;

double quadratic_form(const SymmetricTensor& tensor, const glm::dvec3& direction);

/// Surfaces end at creases, at boundaries, at non-manifold edges and between faces that run against each
/// other: a point there belongs to several parts, and is in the lists once for each.
struct SmoothSurface {
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> point_normals;   ///< Of unit length.
  std::vector<glm::dvec3> normals;         ///< The same smoothed.
  std::vector<SymmetricTensor> curvature;  ///< Tangent to the surface, in 1 / length; smoothed.
  std::vector<std::array<uint32_t, 3>> faces;
  /// Where a line crosses the edge from corner i to corner i + 1: equal for faces of one part on both sides.
  std::vector<std::array<uint32_t, 3>> crossings;
  uint32_t crossing_count = 0;
  double radius = 0.0;                ///< Half the diagonal of the bounding box.
  std::vector<uint32_t> face_starts;  ///< For each point where its faces begin in `point_faces`; and the end.
  std::vector<uint32_t> point_faces;  ///< The faces around each point, in their order.

  /// Crossings, and the middle of each face after them.
  uint32_t line_ids() const { return crossing_count + static_cast<uint32_t>(faces.size()); }
};

/// `smoothing`: standard deviation of the Gaussian-like weights, along the surface, by which first normals
/// and then tensors are averaged, in mean edge lengths; 0: not at all. `stretch` is applied to all positions.
/// Source: Rusinkiewicz, "Estimating curvatures and their derivatives on triangle meshes", 2004; normals are
/// weighted as by Max, 1999. We keep tensors as 3 x 3 matrices, so that averaging needs no common frame.
SmoothSurface make_smooth_surface(const MeshTopology& topology, double crease_angle_deg, double smoothing,
                                  const glm::dmat3& stretch);

}  // namespace inkbench
