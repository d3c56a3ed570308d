// SPDX-License-Identifier: MIT
// Ramps (3.2): the table that replaces the usual zero-to-one brightness, from stops or from an image.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "pipeline/params/description.h"

namespace inkbench {

struct RampParams {
  bool enabled = true;
  Ramp diffuse{{{0.0F, glm::vec3(0.15F)},
                {0.15F, glm::vec3(0.45F)},
                {0.45F, glm::vec3(0.75F)},
                {0.8F, glm::vec3(1.0F)}},
               ""};
  Ramp specular{{{0.0F, glm::vec3(0.0F)}, {0.5F, glm::vec3(1.0F)}}, ""};

  static const Description& description();
};

/// Number of texels in a ramp's table: a step's place is exact to 1/1024.
constexpr int kRampTexels = 1024;

/// The colour at `t` (0 to 1): constant before the first stop and after the last.
glm::vec3 evaluate_ramp(const Ramp& ramp, float t);

/// `kRampTexels` colours, texel i at t = (i + 0.5) / kRampTexels; an image's first row is sampled at its
/// nearest pixel. Errors (input): the image cannot be read.
std::vector<glm::vec3> ramp_table(const Ramp& ramp);

}  // namespace inkbench
