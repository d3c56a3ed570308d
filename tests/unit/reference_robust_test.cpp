// SPDX-License-Identifier: MIT
// Reference lines of meshes that nobody would make on purpose.
#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>

#include "pipeline/mesh/shapes/primitives.h"
#include "tests/unit/reference_support.h"

namespace inkbench {
namespace {

class Random {
 public:
  float operator()() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<float>(state_ >> 40) / 16777216.0F;
  }

 private:
  uint64_t state_ = 7;
};

void expect_sound_lines(const ReferenceScene& scene, const ReferenceLines& lines) {
  for (const auto* group : {&lines.polylines, &lines.whole_creases}) {
    for (const Polyline& line : *group) {
      ASSERT_GE(line.points.size(), 2U);
      EXPECT_GE(length_of(line), 2.99);
      for (const glm::vec2& point : line.points) {
        ASSERT_TRUE(point.x >= 0.0F && point.x <= static_cast<float>(scene.width_px)) << point.x;
        ASSERT_TRUE(point.y >= 0.0F && point.y <= static_cast<float>(scene.height_px)) << point.y;
      }
    }
  }
}

TEST(ReferenceRobust, empty_scene_has_no_lines) {
  ReferenceScene scene;
  EXPECT_TRUE(scene.lines().polylines.empty());
  scene.add(Mesh{});
  const ReferenceLines lines = scene.lines();
  EXPECT_TRUE(lines.polylines.empty());
  EXPECT_EQ(tier_map(lines, {}, 1).count(), 0);
}

TEST(ReferenceRobust, mesh_without_features_has_silhouettes_and_boundaries_only) {
  ReferenceScene scene;
  scene.camera.eye = {2, 1.5F, 4};
  scene.add(make_box(1));
  scene.rasterise();
  SceneMesh mesh = scene.meshes()[0];
  mesh.features = nullptr;
  const ReferenceLines lines =
      reference_lines(std::span(&mesh, 1), scene.camera, scene.depth, scene.object_id);
  EXPECT_EQ(of_class(lines, LineClass::silhouette).size(), 1U);
  EXPECT_TRUE(of_class(lines, LineClass::crease).empty());
}

TEST(ReferenceRobust, triangle_soup_of_all_kinds) {
  Random random;
  Mesh soup;
  for (int i = 0; i < 60; ++i)
    soup.positions.emplace_back(4 * random() - 2, 4 * random() - 2, 8 * random() - 3);
  for (int i = 0; i < 20; ++i) soup.positions.push_back(soup.positions[i]);
  for (int i = 0; i < 20; ++i) soup.positions.push_back((soup.positions[i] + soup.positions[i + 1]) * 0.5F);
  soup.normals.assign(soup.positions.size(), {0, 1, 0});
  const auto any = [&] { return static_cast<uint32_t>(random() * 100.0F) % 100; };
  for (int i = 0; i < 400; ++i) soup.triangles.push_back({any(), any(), any()});
  for (uint32_t i = 0; i < 20; ++i) soup.triangles.push_back({i, i + 1, 80 + i});  // without area
  for (int view = 0; view < 6; ++view) {
    ReferenceScene scene;
    scene.width_px = 90;
    scene.height_px = 70;
    scene.camera.eye = {6 * random() - 3, 6 * random() - 3, 6 * random()};
    scene.camera.target = {0, 0, -5};
    scene.add(soup);
    const ReferenceLines lines = scene.lines();
    expect_sound_lines(scene, lines);
    EXPECT_FALSE(lines.polylines.empty());
  }
}

TEST(ReferenceRobust, hundred_components_have_a_circle_each) {
  Mesh many;
  for (int i = 0; i < 100; ++i) {
    const Mesh ball = make_sphere(12);
    const auto first = static_cast<uint32_t>(many.positions.size());
    for (const glm::vec3& p : ball.positions)
      many.positions.push_back(p * 0.15F + glm::vec3(0.35F * static_cast<float>(i % 10) - 1.6F,
                                                     0.35F * static_cast<float>(i / 10) - 1.6F, 0));
    many.normals.insert(many.normals.end(), ball.normals.begin(), ball.normals.end());
    for (const auto& t : ball.triangles) many.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  ReferenceScene scene;
  scene.width_px = scene.height_px = 512;
  scene.add(many);
  const ReferenceLines lines = scene.lines();
  expect_sound_lines(scene, lines);
  const std::vector<Polyline> silhouettes = of_class(lines, LineClass::silhouette);
  EXPECT_EQ(silhouettes.size(), 100U);
  for (const Polyline& line : silhouettes) EXPECT_TRUE(is_closed_line(line));
}

TEST(ReferenceRobust, torn_mesh_has_boundaries_around_its_holes) {
  Mesh sphere = make_sphere(24);
  sphere.triangles.erase(sphere.triangles.begin() + 300, sphere.triangles.begin() + 340);
  const MeshTopology topology = make_topology(sphere);
  EXPECT_FALSE(boundary_edges(topology).empty());
  for (const float turn : {0.0F, 1.0F, 2.0F, 4.0F}) {
    ReferenceScene scene;
    scene.add(sphere, glm::rotate(glm::mat4(1.0F), turn, glm::vec3(0, 1, 0)));
    expect_sound_lines(scene, scene.lines());
  }
}

TEST(ReferenceRobust, eye_inside_a_mesh_and_tiny_images) {
  for (const int size : {1, 2, 3, 17}) {
    ReferenceScene scene;
    scene.width_px = size;
    scene.height_px = size;
    scene.camera.eye = {0.2F, 0.1F, 0.3F};
    scene.add(make_torus(24, 0.4F));
    scene.add(make_box(2));
    const ReferenceLines lines = scene.lines();
    expect_sound_lines(scene, lines);
    EXPECT_EQ(class_map(lines, LineClass::silhouette).width_px(), size);
  }
}

TEST(ReferenceRobust, hugely_different_edge_lengths_give_finite_curvature) {
  Mesh needle = plain_mesh({{0, 0, 0}, {1e-6F, 0, 0}, {0, 1e3F, 0}, {1, 1, 1}, {1e-6F, 1e-7F, 1e-6F}},
                           {{0, 1, 2}, {1, 0, 3}, {0, 2, 3}, {2, 1, 3}, {1, 4, 3}});
  const MeshFeatures features = make_features(make_topology(needle));
  for (const SymmetricTensor& tensor : features.surface.curvature) {
    for (const double value : tensor) EXPECT_TRUE(std::isfinite(value));
  }
  ReferenceScene scene;
  scene.add(needle);
  expect_sound_lines(scene, scene.lines());
}

}  // namespace
}  // namespace inkbench
