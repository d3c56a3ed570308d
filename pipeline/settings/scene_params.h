// SPDX-License-Identifier: MIT
// What belongs to the scene as a whole.
#pragma once

#include "pipeline/params/description.h"

namespace inkbench {

struct SceneParams {
  glm::vec3 ambient{0.1F};
  glm::vec3 background{1.0F};

  static const Description& description();
};

}  // namespace inkbench
