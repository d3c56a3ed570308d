// SPDX-License-Identifier: MIT
// The camera: where the eye is, what it looks at, and how it projects, which is said here alone. Out: view
// and projection matrices, what each place of the image sees, and how large a pixel is in the world.
#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string_view>

#include "pipeline/params/description.h"

namespace inkbench {

enum class CameraProjection { perspective, orthographic };
template <>
struct ChoiceNames<CameraProjection> {
  static constexpr std::array<std::string_view, 2> names{"perspective", "orthographic"};
};

struct CameraParams {
  glm::vec3 eye{0.0F, 0.0F, 5.0F};
  glm::vec3 target{0.0F};
  glm::vec3 up{0.0F, 1.0F, 0.0F};
  float fov = 45.0F;
  float near = 0.1F;
  float far = 20.0F;
  CameraProjection projection = CameraProjection::perspective;
  float view_height = 5.0F;  ///< Of what an orthographic view shows, in world units.

  static const Description& description();
};

/// World to eye space, right-handed, looking along -z.
glm::mat4 view_matrix(const CameraParams& camera);

/// Eye space to clip space, depth -1 at the near plane and 1 at the far plane (OpenGL's).
glm::mat4 projection_matrix(const CameraParams& camera, float aspect);

bool is_orthographic(const CameraParams& camera);

/// Height of what the image shows in the plane at this distance along the view axis, in world units:
/// 2 tan(fov / 2) distance, and `view_height` at any distance in orthographic views.
double seen_height(const CameraParams& camera, double distance);

/// Side of a pixel in that plane, in world units.
double pixel_size(const CameraParams& camera, double distance, int height_px);

/// What each place of the image sees. At distance z along the view axis, the place (x, y), each from 0 to 1,
/// (0, 0) the lower left corner, sees the point of the world
///   eye + x eye_right + y eye_up + z (ray + x ray_right + y ray_up).
/// The eye's shifts are zero in perspective views, the ray's in orthographic ones.
struct ViewRays {
  glm::vec3 eye, eye_right, eye_up;
  glm::vec3 ray, ray_right, ray_up;
};
ViewRays view_rays(const CameraParams& camera, float aspect);

/// Errors (input): eye and target coincide, `up` is parallel to the view, near is not below far.
void check_camera(const CameraParams& camera);

}  // namespace inkbench
