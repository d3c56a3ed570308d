// SPDX-License-Identifier: MIT
#include "pipeline/settings/camera.h"

#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "pipeline/base/error.h"

namespace inkbench {

const Description& CameraParams::description() {
  static const Description kDescription{
      "camera",
      "Camera",
      {
          field<&CameraParams::eye>({.name = "eye",
                                     .help = "Position of the eye.",
                                     .unit = "world units",
                                     .limits = {-1e6, 1e6},
                                     .slider = {-10, 10}}),
          field<&CameraParams::target>({.name = "target",
                                        .help = "The point that the camera looks at.",
                                        .unit = "world units",
                                        .limits = {-1e6, 1e6},
                                        .slider = {-10, 10}}),
          field<&CameraParams::up>(
              {.name = "up", .help = "The direction that is up in the image.", .limits = {-1, 1}}),
          field<&CameraParams::projection>(
              {.name = "projection",
               .help = "Lines of sight that meet in the eye, or parallel ones, as in a technical drawing."}),
          field<&CameraParams::fov>({.name = "fov",
                                     .help = "Vertical field of view.",
                                     .unit = "deg",
                                     .limits = {0.01, 170},
                                     .slider = {10, 100},
                                     .matters_when = "projection = perspective"}),
          field<&CameraParams::view_height>({.name = "view_height",
                                             .help = "Height of what the image shows.",
                                             .unit = "world units",
                                             .limits = {1e-6, 1e6},
                                             .slider = {0.1, 100},
                                             .scale = Scale::log,
                                             .matters_when = "projection = orthographic"}),
          field<&CameraParams::near>({.name = "near",
                                      .help = "Distance of the near plane.",
                                      .unit = "world units",
                                      .limits = {1e-6, 1e6},
                                      .slider = {0.01, 10},
                                      .scale = Scale::log}),
          field<&CameraParams::far>({.name = "far",
                                     .help = "Distance of the far plane; depth is divided by it.",
                                     .unit = "world units",
                                     .limits = {1e-6, 1e6},
                                     .slider = {1, 100},
                                     .scale = Scale::log}),
      }};
  return kDescription;
}

glm::mat4 view_matrix(const CameraParams& camera) {
  return glm::lookAtRH(camera.eye, camera.target, camera.up);
}

glm::mat4 projection_matrix(const CameraParams& camera, float aspect) {
  if (is_orthographic(camera)) {
    const float up = camera.view_height / 2.0F;
    return glm::orthoRH_NO(-up * aspect, up * aspect, -up, up, camera.near, camera.far);
  }
  return glm::perspectiveRH_NO(glm::radians(camera.fov), aspect, camera.near, camera.far);
}

bool is_orthographic(const CameraParams& camera) {
  return camera.projection == CameraProjection::orthographic;
}

double seen_height(const CameraParams& camera, double distance) {
  if (is_orthographic(camera)) return camera.view_height;
  return 2.0 * std::tan(glm::radians(double{camera.fov}) / 2.0) * distance;
}

double pixel_size(const CameraParams& camera, double distance, int height_px) {
  return seen_height(camera, distance) / height_px;
}

ViewRays view_rays(const CameraParams& camera, float aspect) {
  const glm::vec3 forward = glm::normalize(camera.target - camera.eye);
  const glm::vec3 side = glm::normalize(glm::cross(forward, camera.up));
  const glm::vec3 up = glm::cross(side, forward);
  const glm::vec3 none(0.0F);
  if (is_orthographic(camera)) {
    const glm::vec3 eye_right = side * (camera.view_height * aspect);
    const glm::vec3 eye_up = up * camera.view_height;
    return {camera.eye - (eye_right + eye_up) / 2.0F, eye_right, eye_up, forward, none, none};
  }
  const float half_height = std::tan(glm::radians(camera.fov) / 2.0F);
  const glm::vec3 ray_right = side * (2.0F * half_height * aspect);
  const glm::vec3 ray_up = up * (2.0F * half_height);
  return {camera.eye, none, none, forward - (ray_right + ray_up) / 2.0F, ray_right, ray_up};
}

void check_camera(const CameraParams& camera) {
  const glm::vec3 forward = camera.target - camera.eye;
  if (!(glm::length(forward) > 1e-9F)) {
    throw input_error("camera.eye",
                      "is the same point as camera.target, so there is no direction to look along",
                      "move one of them");
  }
  if (!(glm::length(glm::cross(glm::normalize(forward), camera.up)) > 1e-4F)) {
    throw input_error("camera.up", "is zero or parallel to the line from camera.eye to camera.target",
                      "choose another up direction, such as [0, 1, 0]");
  }
  if (!(camera.near < camera.far)) {
    throw input_error("camera.near", "= " + to_text(Value(camera.near)) +
                                         " is not below camera.far = " + to_text(Value(camera.far)));
  }
}

}  // namespace inkbench
