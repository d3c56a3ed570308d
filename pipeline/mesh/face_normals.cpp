// SPDX-License-Identifier: MIT
#include "pipeline/mesh/face_normals.h"

#include <glm/geometric.hpp>

namespace inkbench {

std::vector<glm::vec3> face_normals(const Mesh& mesh) {
  std::vector<glm::vec3> normals;
  normals.reserve(mesh.triangles.size());
  for (const auto& [i, j, k] : mesh.triangles) {
    const glm::dvec3 corner = mesh.positions[i];
    const glm::dvec3 normal =
        glm::cross(glm::dvec3(mesh.positions[j]) - corner, glm::dvec3(mesh.positions[k]) - corner);
    const double length = glm::length(normal);
    normals.emplace_back(length > 0.0 ? normal / length : glm::dvec3(0.0));
  }
  return normals;
}

}  // namespace inkbench
