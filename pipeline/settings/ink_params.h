// SPDX-License-Identifier: MIT
// How lines are drawn over the shading (3.5).
#pragma once

#include "pipeline/params/description.h"

namespace inkbench {

struct InkParams {
  glm::vec3 colour{0.0F};

  static const Description& description();
};

}  // namespace inkbench
