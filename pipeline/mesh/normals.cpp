// SPDX-License-Identifier: MIT
// Vertex normals from faces. Sums run in double: thousands of thin triangles around one vertex would
// otherwise leave a direction made of rounding.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "pipeline/mesh/normals.h"

namespace inkbench {
double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

std::array<glm::dvec3, 3> weighted_normals(const std::array<glm::dvec3, 3>& corners) {
  const glm::dvec3 scaled = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double length = glm::length(scaled);
  std::array<glm::dvec3, 3> weighted{};
  for (int i = 0; i < 3 && length > 0.0; ++i) {
    const double angle = angle_between(corners[(i + 1) % 3] - corners[i], corners[(i + 2) % 3] - corners[i]);
    weighted[i] = scaled * (angle / length);
  }
  return weighted;
}

void smooth_normals(Mesh& mesh) {
  std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0.0));
  for (const auto& t : mesh.triangles) {
    const auto added = weighted_normals({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]});
    for (int i = 0; i < 3; ++i) sums[t[i]] += added[i];
  }
  mesh.normals.resize(mesh.positions.size());
  std::transform(sums.begin(), sums.end(), mesh.normals.begin(), [](const glm::dvec3& sum) {
    const double length = glm::length(sum);
    // Faces back to back cancel down to rounding, which is no direction either.
    return length > 1e-9 ? glm::vec3(sum / length) : glm::vec3(0.0F, 1.0F, 0.0F);
  });
}

}  // namespace inkbench
