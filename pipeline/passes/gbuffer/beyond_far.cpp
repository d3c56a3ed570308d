// SPDX-License-Identifier: MIT
#include "pipeline/passes/gbuffer/beyond_far.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>

#include "pipeline/base/log.h"
#include "pipeline/base/text.h"

namespace inkbench {

bool is_beyond_far(const DrawItem& item, const CameraParams& camera) {
  const Bounds box = bounds_in_world(item);
  constexpr double kAspect = 2.0;
  const double half_height = seen_height(camera, camera.far) / 2.0;
  const double far_corner = glm::length(glm::dvec3(kAspect * half_height, half_height, camera.far));
  return nearest_along_view(box, camera) > camera.far || distance_outside(box, camera.eye) > far_corner;
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
