// SPDX-License-Identifier: MIT
#include "app/window/scene_bounds.h"

#include <glm/common.hpp>
#include <limits>

namespace inkbench {

Bounds bounds_in_world(const Frame& frame, bool only_main_model) {
  Bounds result{glm::vec3(std::numeric_limits<float>::max()),
                glm::vec3(std::numeric_limits<float>::lowest())};
  const Settings& settings = frame.settings();
  const std::optional<size_t> main = main_model_index(settings);
  for (const DrawItem& item : frame.draw_items()) {
    const auto index = static_cast<size_t>(item.object_id) - 1;
    if (only_main_model && index != main.value_or(0)) continue;
    if (settings.models[index].shape == Shape::inside_out_sphere) continue;  // the room around the scene
    const Bounds bounds = bounds_in_world(item);
    result.low = glm::min(result.low, bounds.low);
    result.high = glm::max(result.high, bounds.high);
  }
  return result.low.x <= result.high.x ? result : Bounds{};
}

}  // namespace inkbench
