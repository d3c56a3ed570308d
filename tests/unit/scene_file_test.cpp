// SPDX-License-Identifier: MIT
// Scenes made of other programs' files: models, a camera that sees them, lights of a sensible strength.
#include "pipeline/mesh/levels/scene_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "pipeline/base/error.h"

namespace inkbench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A part of one triangle.
ImportedPart triangle_at(const std::string& name, const glm::dvec3& place, double size = 1.0) {
  ImportedPart part{name, {}, {0.25F, 0.5F, 0.75F}};
  part.soup.points = {place, place + glm::dvec3(size, 0, 0), place + glm::dvec3(0, size, 0)};
  part.soup.corner_counts = {3};
  part.soup.corners = {0, 1, 2};
  return part;
}

ImportedScene two_triangles() {
  ImportedScene scene;
  scene.parts = {triangle_at("left wheel", {-3, 0, 0}), triangle_at("left  wheel", {2, 1, -4}, 3.0)};
  return scene;
}

Settings settings_of(const ImportedScene& scene) {
  Settings settings = imported_settings(scene, "/models/car.glb");
  check_settings(settings);
  return settings;
}

void expect_in_sight(const Settings& settings, const ImportedScene& scene) {
  const double aspect = static_cast<double>(settings.image.width) / settings.image.height;
  const glm::mat4 to_clip =
      projection_matrix(settings.camera, static_cast<float>(aspect)) * view_matrix(settings.camera);
  for (const ImportedPart& part : scene.parts) {
    for (const glm::dvec3& point : part.soup.points) {
      const glm::vec4 clip = to_clip * glm::vec4(glm::vec3(point), 1.0F);
      for (int i = 0; i < 3; ++i) EXPECT_LT(std::abs(clip[i]), clip.w) << part.name << " " << i;
    }
  }
}

TEST(ImportedSettings, each_part_is_a_model_with_a_name_that_keys_can_hold) {
  const Settings settings = settings_of(two_triangles());
  ASSERT_EQ(settings.models.size(), 2U);
  EXPECT_EQ(settings.models[0].name, "left_wheel");
  EXPECT_EQ(settings.models[1].name, "left_wheel_2");
  EXPECT_EQ(settings.models[1].part, "left  wheel");
  EXPECT_EQ(settings.models[1].mesh, "/models/car.glb");
  EXPECT_EQ(settings.models[1].material.colour, glm::vec3(0.25F, 0.5F, 0.75F));
}

TEST(ImportedSettings, without_a_camera_all_is_in_sight) {
  expect_in_sight(settings_of(two_triangles()), two_triangles());
}

TEST(ImportedSettings, the_files_camera_is_taken_and_its_planes_enclose_the_scene) {
  ImportedScene scene = two_triangles();
  scene.cameras = {{"a", {0, 0, 30}, {0, 0, -2}, {0, 3, 0}, 60.0, 2.0}, {"b", {9, 9, 9}}};
  const CameraParams camera = settings_of(scene).camera;
  EXPECT_EQ(camera.eye, glm::vec3(0, 0, 30));
  EXPECT_NEAR(glm::length(glm::normalize(camera.target - camera.eye) - glm::vec3(0, 0, -1)), 0.0, 1e-6);
  EXPECT_NEAR(camera.fov, 32.2042, 1e-3);  // 2 atan(tan(30 deg) / 2)
  EXPECT_LT(camera.near, 30.0F);
  EXPECT_GT(camera.far, 34.0F);
}

TEST(ImportedSettings, the_files_orthographic_camera_is_taken) {
  ImportedScene scene = two_triangles();
  scene.cameras = {{"a", {0, 0, 30}, {0, 0, -2}, {0, 3, 0}, 0.0, 2.0, 12.0}};
  const CameraParams camera = settings_of(scene).camera;
  EXPECT_EQ(camera.projection, CameraProjection::orthographic);
  EXPECT_EQ(camera.view_height, 12.0F);
  EXPECT_LT(camera.near, 30.0F);
  EXPECT_GT(camera.far, 34.0F);
  expect_in_sight(settings_of(scene), scene);
}

TEST(ImportedSettings, scenes_of_any_size_have_cameras_within_the_limits) {
  for (const double size : {1e-4, 1.0, 2e5}) {
    ImportedScene scene;
    scene.parts = {triangle_at("a", glm::dvec3(0.0), size)};
    Settings settings = settings_of(scene);
    for (const Param& param : list_params(settings)) EXPECT_NO_THROW(param.set(param.value(), "test"));
    expect_in_sight(settings, scene);
  }
}

TEST(ImportedSettings, a_camera_that_is_none_is_passed_over) {
  ImportedScene scene = two_triangles();
  scene.cameras = {{"a", {NAN, 0, 0}}, {"b", {0, 0, 30}, {0, 0, 0}}};
  expect_in_sight(settings_of(scene), scene);
}

TEST(ImportedSettings, lights_are_together_as_bright_as_one_by_what_reaches_the_scene) {
  ImportedScene scene;
  scene.parts = {triangle_at("a", {-0.5, -0.5, 0})};
  scene.lights = {{"sun", ImportedLightType::directional, {}, {0, 2, 0}, {300, 300, 300}},
                  {"lamp", ImportedLightType::point, {0, 10, 0}, {}, {10000, 5000, 0}}};
  const std::vector<LightParams> lights = settings_of(scene).lights;
  ASSERT_EQ(lights.size(), 2U);
  EXPECT_EQ(lights[0].direction, glm::vec3(0, 1, 0));
  EXPECT_NEAR(lights[0].diffuse.x, 0.75, 0.02);
  EXPECT_EQ(lights[1].type, LightType::point);
  EXPECT_NEAR(lights[1].diffuse.x, 0.25, 0.02);
  EXPECT_NEAR(lights[1].diffuse.y / lights[1].diffuse.x, 0.5, 1e-6);
}

TEST(ImportedSettings, without_a_light_there_is_one) {
  EXPECT_EQ(settings_of(two_triangles()).lights.size(), 1U);
}

TEST(ImportedSettings, more_parts_than_a_scene_lists_are_refused_with_the_way_out) {
  ImportedScene scene;
  scene.parts.assign(kMaxModels + 1, triangle_at("a", {0, 0, 0}));
  try {
    imported_settings(scene, "/models/car.glb");
    ADD_FAILURE() << "taken";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("/models/car.glb: has 4097 parts"));
    EXPECT_THAT(error.what(), HasSubstr("--mesh draws the file as one model"));
  }
}

}  // namespace
}  // namespace inkbench
