#include "app/window/scene_bounds.h"

#include <glm/common.hpp>
#include <limits>

namespace inkbench {

Bounds bounds_in_world(Pipeline& pipeline, const Settings& settings, bool only_main_model) {
  Bounds result{glm::vec3(std::numeric_limits<float>::max()),
                glm::vec3(std::numeric_limits<float>::lowest())};
  const std::optional<size_t> main = main_model_index(settings);
  for (const DrawItem& item : pipeline.draw_items(settings)) {
    if (only_main_model && static_cast<size_t>(item.object_id) != main.value_or(0) + 1) continue;
    const Bounds bounds = bounds_in_world(item);
    result.low = glm::min(result.low, bounds.low);
    result.high = glm::max(result.high, bounds.high);
  }
  return result.low.x <= result.high.x ? result : Bounds{};
}

}  // namespace inkbench
