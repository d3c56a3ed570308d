// SPDX-License-Identifier: MIT
// A light: directional or point, with ambient, diffuse and specular intensity (3.1).
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>

#include "pipeline/params/description.h"

namespace inkbench {

enum class LightType { directional, point };
template <>
struct ChoiceNames<LightType> {
  static constexpr std::array<std::string_view, 2> names{"directional", "point"};
};

/// Lights and materials lie in uniform blocks of fixed size: the software renderer reads those several times
/// faster than storage buffers, and every driver has room for these. More materials than that are shaded in
/// several goes.
constexpr int kMaxLights = 64;
constexpr int kMaterialsAtOnce = 256;

struct LightParams {
  std::string name;
  LightType type = LightType::directional;
  glm::vec3 direction{0.0F, 1.0F, 0.0F};
  glm::vec3 position{0.0F, 5.0F, 0.0F};
  glm::vec3 ambient{0.0F};
  glm::vec3 diffuse{1.0F};
  glm::vec3 specular{1.0F};

  static const Description& description();
};

}  // namespace inkbench
