// SPDX-License-Identifier: MIT
#include "pipeline/mesh/levels/level_normals.h"

#include <glm/geometric.hpp>
#include <utility>

#include "pipeline/mesh/formats/mesh_file.h"
#include "pipeline/mesh/normals.h"

namespace inkbench {
namespace {

glm::vec3 face_normal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 scaled = glm::cross(b - a, c - a);
  const double length = glm::length(scaled);
  return length > 0.0 ? glm::vec3(scaled / length) : glm::vec3(0.0F, 1.0F, 0.0F);
}

void apply_flat_normals(Mesh& level) {
  std::vector<glm::vec3> positions;
  positions.reserve(level.triangles.size() * 3);
  level.normals.clear();
  level.normals.reserve(level.triangles.size() * 3);
  for (auto& triangle : level.triangles) {
    const glm::vec3 corners[3] = {level.positions[triangle[0]], level.positions[triangle[1]],
                                  level.positions[triangle[2]]};
    const glm::vec3 normal = face_normal(corners[0], corners[1], corners[2]);
    for (int i = 0; i < 3; ++i) {
      triangle[i] = static_cast<uint32_t>(positions.size());
      positions.push_back(corners[i]);
      level.normals.push_back(normal);
    }
  }
  level.positions = std::move(positions);
}

}  // namespace

void apply_level_normals(Mesh& level, LevelNormals kind, const Mesh& full) {
  switch (kind) {
    case LevelNormals::model:
      return full.has_given_normals ? void() : smooth_normals(level);
    case LevelNormals::smooth:
      return smooth_normals(level);
    case LevelNormals::flat:
      return apply_flat_normals(level);
    case LevelNormals::nearest:
      return apply_nearest_normals(level, NearestNormals(full));
  }
}

Mesh level_with_normals(const Mesh& mesh, const CollapseRecord& record, size_t asked_faces,
                        LevelNormals kind) {
  Mesh level = mesh_at_level(mesh, record, asked_faces);
  const bool is_as_loaded = level.triangles.size() == mesh.triangles.size();
  const bool is_computed =
      kind == LevelNormals::smooth || (kind == LevelNormals::model && !mesh.has_given_normals);
  if (kind == LevelNormals::flat || (is_computed && !is_as_loaded)) apply_level_normals(level, kind, mesh);
  return level;
}

void apply_nearest_normals(Mesh& level, const NearestNormals& full) {
  for (size_t vertex = 0; vertex < level.positions.size(); ++vertex)
    level.normals[vertex] = full.at(level.positions[vertex], level.normals[vertex]);
}

}  // namespace inkbench
