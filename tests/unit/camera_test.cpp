// SPDX-License-Identifier: MIT
// Camera matrices against values worked out by hand.
#include "pipeline/settings/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "pipeline/base/error.h"

namespace inkbench {
namespace {

void expect_near(const glm::vec3& actual, const glm::vec3& expected, float tolerance = 1e-5F) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], tolerance) << "component " << i;
}

glm::vec3 seen(const CameraParams& camera, const glm::vec3& point) {
  return glm::vec3(view_matrix(camera) * glm::vec4(point, 1.0F));
}

glm::vec3 projected(const CameraParams& camera, float aspect, const glm::vec3& eye_space) {
  const glm::vec4 clip = projection_matrix(camera, aspect) * glm::vec4(eye_space, 1.0F);
  return glm::vec3(clip) / clip.w;
}

TEST(Camera, default_view_only_moves_back) {
  const CameraParams camera;  // eye (0, 0, 5), looking at the origin
  expect_near(seen(camera, {0, 0, 0}), {0, 0, -5});
  expect_near(seen(camera, {1, 2, 3}), {1, 2, -2});
}

TEST(Camera, looks_along_negative_z_with_x_to_the_right) {
  CameraParams camera;
  camera.eye = {5, 0, 0};  // from +x: right is -z
  expect_near(seen(camera, {0, 0, 0}), {0, 0, -5});
  expect_near(seen(camera, {0, 0, -1}), {1, 0, -5});
  expect_near(seen(camera, {0, 1, 0}), {0, 1, -5});
}

TEST(Camera, view_from_above_uses_the_given_up) {
  CameraParams camera;
  camera.eye = {1, 4, 2};
  camera.target = {1, 0, 2};
  camera.up = {0, 0, -1};
  expect_near(seen(camera, {1, 0, 2}), {0, 0, -4});
  expect_near(seen(camera, {2, 0, 2}), {1, 0, -4});
  expect_near(seen(camera, {1, 0, 1}), {0, 1, -4});
}

TEST(Camera, up_need_not_be_of_unit_length_or_right_angle) {
  CameraParams camera;
  camera.up = {0, 0.3F, 0.9F};
  expect_near(seen(camera, {0, 1, 0}), {0, 1, -5});
}

TEST(Camera, oblique_view_by_hand) {
  CameraParams camera;
  camera.eye = {3, 0, 4};  // 5 from the target; forward (-0.6, 0, -0.8), right (0.8, 0, -0.6)
  expect_near(seen(camera, {1, 2, 0}), {0.8F, 2, -(5 - 0.6F)});
}

TEST(Camera, depth_is_minus_one_at_near_and_one_at_far) {
  const CameraParams camera;
  EXPECT_NEAR(projected(camera, 1, {0, 0, -0.1F}).z, -1.0F, 1e-5F);
  EXPECT_NEAR(projected(camera, 1, {0, 0, -20.0F}).z, 1.0F, 1e-5F);
}

TEST(Camera, the_field_of_view_is_vertical) {
  CameraParams camera;
  camera.fov = 90.0F;
  expect_near(projected(camera, 2.0F, {0, 3, -3}), {0, 1, projected(camera, 2.0F, {0, 0, -3}).z});
  EXPECT_NEAR(projected(camera, 2.0F, {6, 0, -3}).x, 1.0F, 1e-5F);
  EXPECT_NEAR(projected(camera, 0.5F, {1.5F, 0, -3}).x, 1.0F, 1e-5F);
}

TEST(Camera, projection_matrix_by_hand) {
  CameraParams camera;
  camera.fov = 60.0F;
  camera.near = 1.0F;
  camera.far = 3.0F;
  const glm::mat4 matrix = projection_matrix(camera, 2.0F);
  const float cotangent = std::sqrt(3.0F);  // of 30 degrees
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      float expected = 0.0F;
      if (column == 0 && row == 0) expected = cotangent / 2;
      if (column == 1 && row == 1) expected = cotangent;
      if (column == 2 && row == 2) expected = -(3.0F + 1.0F) / (3.0F - 1.0F);
      if (column == 2 && row == 3) expected = -1.0F;
      if (column == 3 && row == 2) expected = -2.0F * 3.0F * 1.0F / (3.0F - 1.0F);
      EXPECT_NEAR(matrix[column][row], expected, 1e-5F) << column << ", " << row;
    }
  }
}

CameraParams orthographic_camera() {
  CameraParams camera{.eye = {3, 1, 4}, .target = {0.5F, 0, -1}, .up = {0.2F, 1, 0}, .near = 2, .far = 9};
  camera.projection = CameraProjection::orthographic;
  camera.view_height = 3.0F;
  return camera;
}

TEST(Camera, orthographic_projection_by_hand) {
  const CameraParams camera = orthographic_camera();
  expect_near(projected(camera, 2.0F, {3, 1.5F, -2}), {1, 1, -1});
  expect_near(projected(camera, 2.0F, {-3, -0.75F, -9}), {-1, -0.5F, 1});
  EXPECT_NEAR(projected(camera, 2.0F, {0, 0, -5.5F}).z, 0.0F, 1e-6F) << "depth is linear";
}

TEST(Camera, seen_height_and_pixel_size_are_what_the_matrices_show) {
  CameraParams camera = orthographic_camera();
  for (const CameraProjection projection : {CameraProjection::perspective, CameraProjection::orthographic}) {
    camera.projection = projection;
    for (const float distance : {2.0F, 5.0F, 8.5F}) {
      const auto half = static_cast<float>(seen_height(camera, distance) / 2.0);
      EXPECT_NEAR(projected(camera, 1.5F, {0, half, -distance}).y, 1.0F, 1e-5F);
      EXPECT_NEAR(projected(camera, 1.5F, {1.5F * half, 0, -distance}).x, 1.0F, 1e-5F);
      EXPECT_DOUBLE_EQ(pixel_size(camera, distance, 600) * 600, seen_height(camera, distance));
    }
  }
}

TEST(Camera, rays_see_what_the_matrices_project_there) {
  CameraParams camera = orthographic_camera();
  const float aspect = 1.5F;
  for (const CameraProjection projection : {CameraProjection::perspective, CameraProjection::orthographic}) {
    camera.projection = projection;
    const ViewRays rays = view_rays(camera, aspect);
    for (const glm::vec2 place : {glm::vec2(0, 0), glm::vec2(1, 0.25F), glm::vec2(0.3F, 1)}) {
      const float z = 6.0F;
      const glm::vec3 point = rays.eye + place.x * rays.eye_right + place.y * rays.eye_up +
                              z * (rays.ray + place.x * rays.ray_right + place.y * rays.ray_up);
      const glm::vec3 in_view = seen(camera, point);
      EXPECT_NEAR(in_view.z, -z, 1e-5F);
      const glm::vec3 shown = projected(camera, aspect, in_view);
      EXPECT_NEAR(shown.x, 2 * place.x - 1, 1e-5F);
      EXPECT_NEAR(shown.y, 2 * place.y - 1, 1e-5F);
    }
  }
}

TEST(Camera, a_tiny_scenes_camera_is_one) {
  CameraParams camera{.eye = {2e-7F, 0, 0}, .target = {0, 1e-7F, 0}};
  EXPECT_NO_THROW(check_camera(camera));
  camera.target = camera.eye;
  EXPECT_THROW(check_camera(camera), Error);
}

}  // namespace
}  // namespace inkbench
