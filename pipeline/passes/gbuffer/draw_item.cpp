// SPDX-License-Identifier: MIT
#include "pipeline/passes/gbuffer/draw_item.h"

#include <glm/common.hpp>
#include <limits>

namespace inkbench {

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
