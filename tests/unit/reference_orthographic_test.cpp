// SPDX-License-Identifier: MIT
// Reference lines of shapes in orthographic views: facing by the direction of the view, visibility by
// distance.
#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>

#include "pipeline/mesh/shapes/primitives.h"
#include "tests/unit/reference_support.h"

namespace inkbench {
namespace {

ReferenceScene orthographic_scene(float view_height) {
  ReferenceScene scene;
  scene.camera.projection = CameraProjection::orthographic;
  scene.camera.view_height = view_height;
  return scene;
}

TEST(ReferenceOrthographic, sides_that_only_an_eye_beside_the_middle_would_see_are_none) {
  ReferenceScene scene = orthographic_scene(4.0F);
  scene.add(make_box(3), glm::translate(glm::mat4(1.0F), glm::vec3(1.2F, -0.8F, 0.4F)));
  const ReferenceLines lines = scene.lines();
  const std::vector<Polyline> silhouettes = of_class(lines, LineClass::silhouette);
  ASSERT_EQ(silhouettes.size(), 1U);
  EXPECT_TRUE(is_closed_line(silhouettes[0]));
  EXPECT_NEAR(length_of(silhouettes[0]), 4.0 * 256.0 / 4.0, 0.01);
  // The back's edges lie behind those of the front exactly, beside the background.
  for (const glm::dvec2& point : points_along(of_class(lines, LineClass::crease)))
    EXPECT_LT(distance_to(point, silhouettes), 1e-4);
}

TEST(ReferenceOrthographic, what_stands_before_a_box_hides_its_lines) {
  ReferenceScene scene = orthographic_scene(2.0F);  // 128 px each unit
  scene.add(make_box(1));
  const double all = total_length(of_class(scene.lines(), LineClass::silhouette));
  // A second box of twice the size, whose right side runs through the first one's middle.
  scene.add(make_box(1), glm::translate(glm::mat4(1.0F), glm::vec3(-1.0F, 0.0F, 2.0F)) *
                             glm::scale(glm::mat4(1.0F), glm::vec3(2.0F)));
  std::vector<Polyline> of_first = of_class(scene.lines(), LineClass::silhouette);
  std::erase_if(of_first, [](const Polyline& line) { return line.object_id != 1; });
  EXPECT_NEAR(all, 4.0 * 128.0, 0.01);
  EXPECT_NEAR(total_length(of_first), 2.0 * 128.0, 3.0);
  for (const Polyline& line : of_first) {
    for (const glm::vec2& point : line.points) EXPECT_GT(point.x, 126.0F);
  }
}

TEST(ReferenceOrthographic, sphere_is_a_circle_of_its_own_radius) {
  ReferenceScene scene = orthographic_scene(4.0F);
  scene.camera.eye = {3.0F, 2.0F, 4.0F};
  scene.add(make_sphere(64));
  const std::vector<Polyline> silhouettes = of_class(scene.lines(), LineClass::silhouette);
  ASSERT_EQ(silhouettes.size(), 1U);
  EXPECT_TRUE(is_closed_line(silhouettes[0]));
  for (const glm::vec2& point : silhouettes[0].points)
    EXPECT_NEAR(glm::length(glm::dvec2(point) - glm::dvec2(128.0)), 64.0, 0.3);
}

TEST(ReferenceOrthographic, a_direction_sees_what_an_eye_very_far_away_in_it_does) {
  Mesh dented = make_sphere(48);
  for (glm::vec3& p : dented.positions) p *= 1.0F + 0.2F * std::sin(5.0F * p.x) * std::sin(5.0F * p.y + 1.0F);
  const MeshTopology topology = make_topology(dented);
  FeatureParams params;
  params.stretch[1][1] = 1.5;
  const MeshFeatures features = make_features(topology, params);
  const glm::dvec3 direction(0.3, 0.5, 0.9);
  const Viewpoint eye = 1e9 * direction;
  const Viewpoint infinity = Viewpoint::at_infinity(direction);
  EXPECT_EQ(face_facings(topology, infinity), face_facings(topology, eye));
  const std::vector<Polyline3> expected = suggestive_contours(features, eye);
  const std::vector<Polyline3> lines = suggestive_contours(features, infinity);
  ASSERT_FALSE(lines.empty());
  ASSERT_EQ(lines.size(), expected.size());
  for (size_t i = 0; i < lines.size(); ++i) {
    ASSERT_EQ(lines[i].points.size(), expected[i].points.size());
    for (size_t j = 0; j < lines[i].points.size(); ++j)
      EXPECT_LT(glm::length(lines[i].points[j] - expected[i].points[j]), 1e-6);
  }
}

}  // namespace
}  // namespace inkbench
