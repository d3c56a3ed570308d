// SPDX-License-Identifier: MIT
// Vertex normals from faces. Sums run in double: thousands of thin triangles around one vertex would
// otherwise leave a direction made of rounding.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "pipeline/mesh/normals.h"

namespace inkbench {
namespace {

void add_face_normal(const Mesh& mesh, const std::array<uint32_t, 3>& triangle,
                     std::vector<glm::dvec3>& sums) {
  glm::dvec3 corner[3];
  for (int i = 0; i < 3; ++i) corner[i] = mesh.positions[triangle[i]];
  const glm::dvec3 scaled_normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
  const double length = glm::length(scaled_normal);
  if (!(length > 0.0)) return;
  for (int i = 0; i < 3; ++i) {
    const double angle = angle_between(corner[(i + 1) % 3] - corner[i], corner[(i + 2) % 3] - corner[i]);
    sums[triangle[i]] += scaled_normal * (angle / length);
  }
}

}  // namespace

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

void smooth_normals(Mesh& mesh) {
  std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0.0));
  for (const std::array<uint32_t, 3>& triangle : mesh.triangles) add_face_normal(mesh, triangle, sums);
  mesh.normals.resize(mesh.positions.size());
  std::transform(sums.begin(), sums.end(), mesh.normals.begin(), [](const glm::dvec3& sum) {
    const double length = glm::length(sum);
    // Faces back to back cancel down to rounding, which is no direction either.
    return length > 1e-9 ? glm::vec3(sum / length) : glm::vec3(0.0F, 1.0F, 0.0F);
  });
}

}  // namespace inkbench
