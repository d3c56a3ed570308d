// SPDX-License-Identifier: MIT
#include "pipeline/mesh/levels/imported_view.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace inkbench {
namespace {

constexpr double kDefaultFovDeg = 38.0;
constexpr double kNearestShare = 1e-3;  ///< Of the far plane's distance, to spare depth its precision.
constexpr double kRoom = 1.05;          ///< Around what is in sight.
constexpr double kFarthest = 1e6;       ///< The limit of places in settings.
const glm::dvec3 kFromFront(0.45, 0.4, 1.0);

bool is_finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool has_direction(const glm::dvec3& v) {
  return is_finite(v) && glm::length(v) > 0.0;
}

double vertical_fov_deg(const ImportedCamera& camera, double image_aspect) {
  const double aspect = camera.aspect > 0.0 ? camera.aspect : image_aspect;
  const double half = std::tan(glm::radians(camera.horizontal_fov_deg) / 2.0) / aspect;
  const double fov = glm::degrees(2.0 * std::atan(half));
  return fov > 0.0 && std::isfinite(fov) ? std::clamp(fov, 0.01, 170.0) : kDefaultFovDeg;
}

/// Within the parameter's limits.
float view_height_param(double height) {
  return static_cast<float>(std::clamp(height, 1e-6, 1e6));
}

/// A direction that is not along `forward`, `wanted` if that is none.
glm::dvec3 up_beside(const glm::dvec3& forward, const glm::dvec3& wanted) {
  for (const glm::dvec3& up : {wanted, glm::dvec3(0, 1, 0), glm::dvec3(0, 0, -1)}) {
    if (has_direction(up) && glm::length(glm::cross(forward, glm::normalize(up))) > 1e-3)
      return glm::normalize(up);
  }
  return {1, 0, 0};
}

bool is_usable(const ImportedCamera& camera) {
  return is_finite(camera.eye) && glm::length(camera.eye) < kFarthest && has_direction(camera.direction);
}

/// Sets near and far so that the box lies between them; what is behind the eye counts as at it.
void enclose(const SceneBox& box, CameraParams& camera) {
  const glm::dvec3 eye = camera.eye;
  const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.target) - eye);
  double nearest = INFINITY, farthest = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 place((corner & 1) != 0 ? box.high.x : box.low.x,
                           (corner & 2) != 0 ? box.high.y : box.low.y,
                           (corner & 4) != 0 ? box.high.z : box.low.z);
    const double depth = glm::dot(place - eye, forward);
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  if (!(farthest > 0.0)) farthest = glm::length(box.middle() - eye) + box.radius();  // it looks away
  camera.far = static_cast<float>(std::clamp(farthest * kRoom, 1e-5, 1e6));
  camera.near = static_cast<float>(
      std::clamp<double>(nearest / kRoom, std::max(1e-6, camera.far * kNearestShare), camera.far / 2));
}

CameraParams camera_of_file(const ImportedCamera& imported, const SceneBox& box, double aspect) {
  CameraParams camera;
  const glm::dvec3 forward = glm::normalize(imported.direction);
  // Turning about the target in the window turns about the middle of what is seen.
  const double depth = glm::dot(box.middle() - imported.eye, forward);
  camera.eye = imported.eye;
  camera.target = imported.eye + forward * (depth > 0.0 ? depth : box.radius() > 0.0 ? box.radius() : 1.0);
  camera.up = up_beside(forward, imported.up);
  camera.fov = static_cast<float>(vertical_fov_deg(imported, aspect));
  if (!(imported.view_height > 0.0)) return camera;
  camera.projection = CameraProjection::orthographic;
  camera.view_height = view_height_param(imported.view_height);
  return camera;
}

CameraParams camera_in_front(const SceneBox& box, double aspect) {
  CameraParams camera;
  const double half_angle = std::atan(std::tan(glm::radians(kDefaultFovDeg) / 2.0) * std::min(1.0, aspect));
  camera.fov = static_cast<float>(kDefaultFovDeg);
  camera.target = box.middle();
  camera.eye = box.middle() + glm::normalize(kFromFront) * (kRoom * box.radius() / std::sin(half_angle));
  return camera;
}

LightParams light_over_shoulder(const CameraParams& camera) {
  LightParams light;
  const glm::dvec3 back = glm::normalize(glm::dvec3(camera.eye) - glm::dvec3(camera.target));
  const glm::dvec3 up(camera.up);
  const glm::dvec3 left = glm::normalize(glm::cross(back, up));
  light.name = "key";
  light.direction = glm::normalize(back + 0.7 * left + 0.9 * up);
  light.ambient = glm::vec3(0.1F);
  light.diffuse = glm::vec3(0.9F);
  light.specular = glm::vec3(0.8F);
  return light;
}

/// What reaches the middle of the scene.
glm::dvec3 arriving(const ImportedLight& light, const SceneBox& box) {
  glm::dvec3 intensity = glm::max(light.intensity, glm::dvec3(0.0));
  if (!is_finite(intensity)) return glm::dvec3(0.0);
  if (light.type == ImportedLightType::directional) return intensity;
  const double distance = std::max(glm::length(light.position - box.middle()), box.radius() / 10.0);
  return distance > 0.0 ? intensity / (distance * distance) : intensity;
}

double strength(const glm::dvec3& colour) {
  return std::max({colour.x, colour.y, colour.z});
}

LightParams light_of_file(const ImportedLight& imported, const glm::dvec3& brightness) {
  LightParams light;
  light.diffuse = light.specular = glm::vec3(brightness);
  const bool is_point = imported.type == ImportedLightType::point;
  const double distance = glm::length(imported.position);
  light.type = is_point && distance < kFarthest ? LightType::point : LightType::directional;
  if (light.type == LightType::point) light.position = imported.position;
  // One that is too far away for its place shines like the sun.
  if (light.type == LightType::directional)
    light.direction = glm::normalize(is_point ? imported.position : imported.direction);
  return light;
}

bool is_usable(const ImportedLight& light) {
  return light.type == ImportedLightType::point ? is_finite(light.position) : has_direction(light.direction);
}

}  // namespace

CameraParams imported_camera(const ImportedScene& scene, const SceneBox& box, double aspect) {
  const auto found =
      std::ranges::find_if(scene.cameras, [](const ImportedCamera& camera) { return is_usable(camera); });
  CameraParams camera =
      found != scene.cameras.end() ? camera_of_file(*found, box, aspect) : camera_in_front(box, aspect);
  enclose(box, camera);
  if (is_orthographic(camera)) return camera;
  // So that it shows as much at the target when it is made orthographic.
  const double seen = seen_height(camera, glm::length(glm::dvec3(camera.target) - glm::dvec3(camera.eye)));
  camera.view_height = view_height_param(seen);
  return camera;
}

std::vector<LightParams> imported_lights(const ImportedScene& scene, const SceneBox& box,
                                         const CameraParams& camera) {
  double sum = 0.0;
  std::vector<const ImportedLight*> usable;
  for (const ImportedLight& light : scene.lights) {
    const double arrives = is_usable(light) ? strength(arriving(light, box)) : 0.0;
    if (arrives > 0.0 && usable.size() < kMaxLights) usable.push_back(&light);
    if (arrives > 0.0) sum += arrives;
  }
  std::vector<LightParams> lights;
  for (const ImportedLight* const light : usable)
    lights.push_back(light_of_file(*light, arriving(*light, box) / sum));
  if (lights.empty()) return {light_over_shoulder(camera)};
  for (size_t i = 0; i < lights.size(); ++i) lights[i].name = usable[i]->name;
  return lights;
}

}  // namespace inkbench
