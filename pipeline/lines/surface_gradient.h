// SPDX-License-Identifier: MIT
// Derivatives over a smooth surface. In: a scalar at each of its points. Out: gradients, along the surface.
#pragma once

#include <vector>

#include "pipeline/lines/smooth_surface.h"

namespace inkbench {

/// Gradient of a scalar given at the points, at one of them: that of the faces around, averaged by area.
glm::dvec3 gradient_at_point(const SmoothSurface& surface, const std::vector<double>& scalar, uint32_t point);

/// Gradient of a scalar that is linear on a face, from its values at the corners; 0 on a face without area.
glm::dvec3 gradient_on_face(const SmoothSurface& surface, uint32_t face, const glm::dvec3& scalar);

}  // namespace inkbench
