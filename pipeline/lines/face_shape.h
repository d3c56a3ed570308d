// SPDX-License-Identifier: MIT
// A face of a smooth surface as vectors.
#pragma once

#include <array>
#include <glm/geometric.hpp>

#include "pipeline/lines/smooth_surface.h"

namespace inkbench {

struct FaceShape {
  std::array<glm::dvec3, 3> edges;  ///< From corner i to corner i + 1.
  glm::dvec3 normal;                ///< Twice the area long.
};

inline FaceShape shape_of(const SmoothSurface& surface, const std::array<uint32_t, 3>& face) {
  FaceShape shape{};
  for (size_t i = 0; i < 3; ++i)
    shape.edges[i] = surface.positions[face[(i + 1) % 3]] - surface.positions[face[i]];
  shape.normal = glm::cross(shape.edges[0], shape.edges[1]);
  return shape;
}

}  // namespace inkbench
