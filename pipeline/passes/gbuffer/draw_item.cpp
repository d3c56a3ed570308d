// SPDX-License-Identifier: MIT
#include "pipeline/passes/gbuffer/draw_item.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace inkbench {

double distance_outside(const Bounds& box, const glm::vec3& point) {
  const glm::dvec3 below = glm::dvec3(box.low) - glm::dvec3(point);
  const glm::dvec3 above = glm::dvec3(point) - glm::dvec3(box.high);
  return glm::length(glm::max(glm::max(below, above), glm::dvec3(0.0)));
}

double nearest_along_view(const Bounds& box, const CameraParams& camera) {
  const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.target) - glm::dvec3(camera.eye));
  double nearest = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = double{box.low[axis]} - camera.eye[axis];
    const double high = double{box.high[axis]} - camera.eye[axis];
    nearest += std::min(low * forward[axis], high * forward[axis]);
  }
  return nearest;
}

Bounds bounds_in_world(const DrawItem& item) {
  const Bounds& bounds = item.mesh->bounds();
  glm::vec3 low(std::numeric_limits<float>::max());
  glm::vec3 high(std::numeric_limits<float>::lowest());
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 model((corner & 1) != 0 ? bounds.high.x : bounds.low.x,
                          (corner & 2) != 0 ? bounds.high.y : bounds.low.y,
                          (corner & 4) != 0 ? bounds.high.z : bounds.low.z);
    const glm::vec3 world(item.model_to_world * glm::vec4(model, 1.0F));
    low = glm::min(low, world);
    high = glm::max(high, world);
  }
  return {low, high};
}

}  // namespace inkbench
