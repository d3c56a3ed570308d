// SPDX-License-Identifier: MIT
#include "pipeline/mesh/mesh.h"

#include <cmath>

#include <glm/common.hpp>

namespace inkbench {

Bounds bounds_of(const Mesh& mesh) {
  if (mesh.triangles.empty()) return {};
  const glm::vec3& first = mesh.positions[mesh.triangles[0][0]];
  Bounds bounds{first, first, mesh.origin, mesh.unit};
  for (const std::array<uint32_t, 3>& triangle : mesh.triangles) {
    for (const uint32_t vertex : triangle) {
      bounds.low = glm::min(bounds.low, mesh.positions[vertex]);
      bounds.high = glm::max(bounds.high, mesh.positions[vertex]);
    }
  }
  return bounds;
}

bool is_finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace inkbench
