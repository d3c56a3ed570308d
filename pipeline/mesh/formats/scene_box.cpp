// SPDX-License-Identifier: MIT
#include "pipeline/mesh/formats/scene_box.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace inkbench {
namespace {

constexpr double kSmallest = 1e-4;
constexpr double kLargest = 2e5;
constexpr double kFarInSizes = 100.0;
constexpr double kFarthest = 5e5;  ///< Beyond, cameras would leave the limits of their parameters.

bool is_finite_point(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

double scale_for(double size) {
  if (!(size > 0.0) || !std::isfinite(size) || (size >= kSmallest && size <= kLargest)) return 1.0;
  return std::pow(10.0, -std::floor(std::log10(size)));
}

void move_and_scale(ImportedScene& scene, const glm::dvec3& middle, double scale) {
  for (ImportedPart& part : scene.parts) {
    for (glm::dvec3& point : part.soup.points) point = (point - middle) * scale;
  }
  for (ImportedCamera& camera : scene.cameras) {
    camera.eye = (camera.eye - middle) * scale;
    camera.view_height *= scale;
  }
  for (ImportedLight& light : scene.lights) {
    light.position = (light.position - middle) * scale;
    if (light.type == ImportedLightType::point) light.intensity *= scale * scale;
  }
}

}  // namespace

double SceneBox::radius() const {
  return glm::length(high - low) / 2.0;
}

SceneBox box_of(const ImportedScene& scene) {
  SceneBox box{glm::dvec3(INFINITY), glm::dvec3(-INFINITY)};
  for (const ImportedPart& part : scene.parts) {
    for (const int32_t corner : part.soup.corners) {
      if (corner < 0 || static_cast<size_t>(corner) >= part.soup.points.size()) continue;
      const glm::dvec3& point = part.soup.points[static_cast<size_t>(corner)];
      if (!is_finite_point(point)) continue;
      box.low = glm::min(box.low, point);
      box.high = glm::max(box.high, point);
    }
  }
  return box.low.x <= box.high.x ? box : SceneBox{};
}

void bring_into_reach(ImportedScene& scene) {
  const SceneBox box = box_of(scene);
  const double size = 2.0 * box.radius();
  const double distance = glm::length(box.middle());
  const double scale = scale_for(size);
  const bool is_far = size > 0.0 && (distance > kFarInSizes * size || distance * scale > kFarthest);
  const glm::dvec3 middle = is_far ? box.middle() : glm::dvec3(0.0);
  if (!is_far && scale == 1.0) return;
  move_and_scale(scene, middle, scale);
  if (is_far) {
    scene.notes.push_back(
        fmt::format("Moved to the origin from ({:g}, {:g}, {:g}).", middle.x, middle.y, middle.z));
  }
  if (scale != 1.0) scene.notes.push_back(fmt::format("Scaled by {:g} from a size of {:g}.", scale, size));
}

}  // namespace inkbench
