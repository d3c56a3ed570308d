// SPDX-License-Identifier: MIT
#include "pipeline/passes/gbuffer/beyond_far.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "pipeline/base/log.h"
#include "pipeline/base/text.h"

namespace inkbench {

bool is_beyond_far(const DrawItem& item, const CameraParams& camera) {
  const Bounds box = bounds_in_world(item);
  const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.target) - glm::dvec3(camera.eye));
  double nearest = 0.0;  // the box's corner that lies least far along the view
  for (int axis = 0; axis < 3; ++axis) {
    const double low = box.low[axis] - camera.eye[axis], high = box.high[axis] - camera.eye[axis];
    nearest += std::min(low * forward[axis], high * forward[axis]);
  }
  const double away = distance_outside(box, camera.eye);
  const double slope = std::tan(glm::radians(static_cast<double>(camera.fov)) / 2.0);
  constexpr double kAspect = 2.0;
  return nearest > camera.far ||
         away > camera.far * std::sqrt(1.0 + slope * slope * (1.0 + kAspect * kAspect));
}

void BeyondFarNotes::update(std::span<const DrawItem> items, const CameraParams& camera) {
  std::set<int> beyond;
  for (const DrawItem& item : items) {
    if (!is_beyond_far(item, camera)) continue;
    beyond.insert(item.object_id);
    if (beyond_.contains(item.object_id)) continue;
    log_note(fmt::format("model '{}' lies beyond the far plane and is not drawn: camera.far is {}", item.name,
                         shortest(camera.far)));
  }
  beyond_ = std::move(beyond);
}

}  // namespace inkbench
