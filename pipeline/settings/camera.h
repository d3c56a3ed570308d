// SPDX-License-Identifier: MIT
// The camera: where the eye is, what it looks at, and the frustum. Out: view and projection matrices.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "pipeline/params/description.h"

namespace inkbench {

struct CameraParams {
  glm::vec3 eye{0.0F, 0.0F, 5.0F};
  glm::vec3 target{0.0F};
  glm::vec3 up{0.0F, 1.0F, 0.0F};
  float fov = 45.0F;
  float near = 0.1F;
  float far = 20.0F;

  static const Description& description();
};

/// World to eye space, right-handed, looking along -z.
glm::mat4 view_matrix(const CameraParams& camera);

/// Eye space to clip space, depth -1 at the near plane and 1 at the far plane (OpenGL's).
glm::mat4 projection_matrix(const CameraParams& camera, float aspect);

/// Errors (input): eye and target coincide, `up` is parallel to the view, near is not below far.
void check_camera(const CameraParams& camera);

}  // namespace inkbench
