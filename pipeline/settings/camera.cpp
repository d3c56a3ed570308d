// SPDX-License-Identifier: MIT
#include "pipeline/settings/camera.h"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

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
                                     .limits = {-1e4, 1e4},
                                     .slider = {-10, 10}}),
          field<&CameraParams::target>({.name = "target",
                                        .help = "The point that the camera looks at.",
                                        .unit = "world units",
                                        .limits = {-1e4, 1e4},
                                        .slider = {-10, 10}}),
          field<&CameraParams::up>(
              {.name = "up", .help = "The direction that is up in the image.", .limits = {-1, 1}}),
          field<&CameraParams::fov>({.name = "fov",
                                     .help = "Vertical field of view.",
                                     .unit = "deg",
                                     .limits = {0.01, 170},
                                     .slider = {10, 100}}),
          field<&CameraParams::near>({.name = "near",
                                      .help = "Distance of the near plane.",
                                      .unit = "world units",
                                      .limits = {1e-4, 1e4},
                                      .slider = {0.01, 10},
                                      .scale = Scale::log}),
          field<&CameraParams::far>({.name = "far",
                                     .help = "Distance of the far plane; depth is divided by it.",
                                     .unit = "world units",
                                     .limits = {1e-3, 1e5},
                                     .slider = {1, 100},
                                     .scale = Scale::log}),
      }};
  return kDescription;
}

glm::mat4 view_matrix(const CameraParams& camera) {
  return glm::lookAtRH(camera.eye, camera.target, camera.up);
}

glm::mat4 projection_matrix(const CameraParams& camera, float aspect) {
  return glm::perspectiveRH_NO(glm::radians(camera.fov), aspect, camera.near, camera.far);
}

void check_camera(const CameraParams& camera) {
  const glm::vec3 forward = camera.target - camera.eye;
  if (!(glm::length(forward) > 1e-6F)) {
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
