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
    const Bounds& bounds = item.mesh->bounds();
    for (int corner = 0; corner < 8; ++corner) {
      const glm::vec3 model((corner & 1) != 0 ? bounds.high.x : bounds.low.x,
                            (corner & 2) != 0 ? bounds.high.y : bounds.low.y,
                            (corner & 4) != 0 ? bounds.high.z : bounds.low.z);
      const glm::vec3 world(item.model_to_world * glm::vec4(model, 1.0F));
      result.low = glm::min(result.low, world);
      result.high = glm::max(result.high, world);
    }
  }
  return result.low.x <= result.high.x ? result : Bounds{};
}

}  // namespace inkbench
