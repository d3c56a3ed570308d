// SPDX-License-Identifier: MIT
// Smooth, flat and nearest normals of levels.
#include "pipeline/mesh/levels/level_normals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "pipeline/mesh/closed.h"
#include "pipeline/mesh/levels/decimation.h"
#include "pipeline/mesh/levels/subdivide.h"
#include "pipeline/mesh/shapes/primitives.h"

namespace inkbench {
namespace {

glm::vec3 face_normal(const Mesh& mesh, const std::array<uint32_t, 3>& t) {
  const glm::dvec3 a = mesh.positions[t[0]];
  return glm::normalize(
      glm::cross(glm::dvec3(mesh.positions[t[1]]) - a, glm::dvec3(mesh.positions[t[2]]) - a));
}

Mesh level_of(const Mesh& mesh, size_t faces) {
  return mesh_at_level(mesh, record_collapses(mesh), faces);
}

TEST(LevelNormals, flat_gives_each_face_its_own) {
  const Mesh sphere = make_sphere(16);
  Mesh level = level_of(sphere, 200);
  apply_level_normals(level, LevelNormals::flat, sphere);
  EXPECT_EQ(level.positions.size(), 3 * level.triangles.size());
  EXPECT_TRUE(is_closed_outwards(level)) << "positions do not move";
  for (const auto& t : level.triangles) {
    for (const uint32_t vertex : t)
      EXPECT_NEAR(glm::dot(level.normals[vertex], face_normal(level, t)), 1.0F, 1e-5F);
  }
}

TEST(LevelNormals, smooth_knows_only_the_level) {
  const Mesh sphere = make_sphere(16);
  Mesh level = level_of(sphere, 60);
  Mesh from_elsewhere = level;
  apply_level_normals(level, LevelNormals::smooth, sphere);
  apply_level_normals(from_elsewhere, LevelNormals::smooth, make_box(1));
  EXPECT_EQ(level.normals, from_elsewhere.normals);
  float worst = 1.0F;
  for (size_t i = 0; i < level.positions.size(); ++i) {
    const float fit = glm::dot(level.normals[i], level.positions[i]);
    EXPECT_GT(fit, 0.8F);
    worst = std::min(worst, fit);
  }
  EXPECT_LT(worst, 0.9999F) << "the level's geometry is not the sphere's";
}

TEST(LevelNormals, nearest_are_those_of_the_full_mesh) {
  const Mesh sphere = make_sphere(32);
  Mesh level = level_of(sphere, 60);
  level.normals.assign(level.positions.size(), glm::vec3(0, 1, 0));
  apply_level_normals(level, LevelNormals::nearest, sphere);
  for (size_t i = 0; i < level.positions.size(); ++i)
    EXPECT_NEAR(glm::dot(level.normals[i], level.positions[i]), 1.0F, 1e-5F);
}

TEST(LevelNormals, nearest_keeps_the_sharp_edges_of_a_box) {
  const Mesh box = make_box(4);
  Mesh level = level_of(box, 12);
  apply_level_normals(level, LevelNormals::nearest, box);
  for (const auto& t : level.triangles) {
    for (const uint32_t vertex : t)
      EXPECT_NEAR(glm::dot(level.normals[vertex], face_normal(level, t)), 1.0F, 1e-5F);
  }
}

TEST(LevelNormals, a_levels_own_normals_are_the_nearest) {
  for (const Mesh& mesh : {make_torus(24, 0.35F), make_box(4)}) {
    const CollapseRecord record = record_collapses(mesh);
    const Mesh level = level_with_normals(mesh, record, 100, LevelNormals::nearest);
    Mesh looked_up = level;
    apply_level_normals(looked_up, LevelNormals::nearest, mesh);
    for (size_t i = 0; i < level.normals.size(); ++i)
      EXPECT_NEAR(glm::dot(level.normals[i], looked_up.normals[i]), 1.0F, 1e-5F);
  }
}

TEST(LevelNormals, as_loaded_keeps_the_files_normals_unless_flat) {
  Mesh mesh = make_torus(12, 0.35F);
  for (glm::vec3& normal : mesh.normals) normal = -normal;
  const CollapseRecord record = record_collapses(mesh);
  EXPECT_EQ(level_with_normals(mesh, record, 0, LevelNormals::smooth).normals, mesh.normals);
  EXPECT_EQ(level_with_normals(mesh, record, 0, LevelNormals::nearest).normals, mesh.normals);
  const Mesh flat = level_with_normals(mesh, record, 0, LevelNormals::flat);
  EXPECT_EQ(flat.normals.size(), 3 * mesh.triangles.size());
  const Mesh smooth = level_with_normals(mesh, record, 100, LevelNormals::smooth);
  Mesh direct = mesh_at_level(mesh, record, 100);
  apply_level_normals(direct, LevelNormals::smooth, mesh);
  EXPECT_EQ(smooth.normals, direct.normals);
}

/// The nearest of many points spread over all triangles, and its distance.
float sampled_distance(const Mesh& mesh, const glm::vec3& point) {
  float best = 1e9F;
  for (const auto& t : mesh.triangles) {
    for (int i = 0; i <= 8; ++i) {
      for (int j = 0; i + j <= 8; ++j) {
        const float u = static_cast<float>(i) / 8;
        const float v = static_cast<float>(j) / 8;
        best = std::min(best, glm::distance(point, (1 - u - v) * mesh.positions[t[0]] +
                                                       u * mesh.positions[t[1]] + v * mesh.positions[t[2]]));
      }
    }
  }
  return best;
}

TEST(LevelNormals, the_nearest_point_is_nearest_among_all_triangles) {
  // Normals that are positions, so that the answer is the direction of the nearest point from the origin.
  Mesh torus = make_torus(8, 0.4F);
  for (glm::vec3& p : torus.positions) p += glm::vec3(0, 3, 0);
  for (size_t i = 0; i < torus.normals.size(); ++i) torus.normals[i] = torus.positions[i];
  const NearestNormals nearest(torus);
  uint32_t random = 3;
  const auto draw = [&] {
    random = random * 1664525U + 1013904223U;
    return static_cast<float>(random >> 8) / 8388608.0F - 1.0F;
  };
  for (int i = 0; i < 300; ++i) {
    const glm::vec3 point = glm::vec3(0, 3, 0) + 1.6F * glm::vec3(draw(), draw(), draw());
    // The line in that direction comes as near to the point as the nearest sample, or nearer.
    const glm::vec3 direction = nearest.at(point, {0, 1, 0});
    const float sampled = sampled_distance(torus, point);
    const float along = glm::length(point - glm::dot(point, direction) * direction);
    EXPECT_LE(along, sampled + 1e-4F);
  }
}

TEST(LevelNormals, the_tree_answers_as_a_list_does) {
  const Mesh torus = make_torus(16, 0.4F);
  const NearestNormals tree(torus);
  uint32_t random = 5;
  const auto draw = [&] {
    random = random * 1664525U + 1013904223U;
    return static_cast<float>(random >> 8) / 8388608.0F - 1.0F;
  };
  for (int i = 0; i < 100; ++i) {
    const glm::vec3 point = 1.5F * glm::vec3(draw(), 0.4F * draw(), draw());
    // One tree for each triangle is a list; the nearest triangle's answer must be the whole tree's.
    float best = 1e9F;
    glm::vec3 expected(0.0F);
    for (const auto& t : torus.triangles) {
      Mesh one;
      one.positions = torus.positions;
      one.normals = torus.normals;
      one.triangles = {t};
      const float distance = sampled_distance(one, point);
      if (distance < best) {
        best = distance;
        expected = NearestNormals(one).at(point, {0, 1, 0});
      }
    }
    EXPECT_GT(glm::dot(tree.at(point, {0, 1, 0}), expected), 0.98F);
  }
}

TEST(LevelNormals, kinds_have_names_in_their_order) {
  EXPECT_EQ(ChoiceNames<LevelNormals>::names[static_cast<size_t>(LevelNormals::smooth)], "smooth");
  EXPECT_EQ(ChoiceNames<LevelNormals>::names[static_cast<size_t>(LevelNormals::flat)], "flat");
  EXPECT_EQ(ChoiceNames<LevelNormals>::names[static_cast<size_t>(LevelNormals::nearest)], "nearest");
}

}  // namespace
}  // namespace inkbench
