// SPDX-License-Identifier: MIT
// Principal curvatures. In: a curvature tensor at a point of a surface. Out: how the surface bends most and
// least, and in which direction most.
#pragma once

#include <glm/vec3.hpp>

#include "pipeline/lines/smooth_surface.h"

namespace inkbench {

/// The larger principal curvature (positive: convex) with its direction, unit, its sign arbitrary.
struct Principal {
  double larger = 0.0, smaller = 0.0;
  glm::dvec3 direction{0.0};
};

/// `sign` 1: of the surface as it is, -1: of the surface turned inside out. The normal is of unit length.
Principal principal_of(const SymmetricTensor& curvature, const glm::dvec3& normal, double sign = 1.0);

/// Any unit vector at right angles to a unit vector.
glm::dvec3 perpendicular(const glm::dvec3& normal);

}  // namespace inkbench
