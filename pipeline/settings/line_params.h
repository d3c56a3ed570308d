// SPDX-License-Identifier: MIT
// How placed lines look: width, taper, edge, and what each class has of its own. Of every method but the
// paper's, whose lines are what its filter gives.
#pragma once

#include <array>
#include <string_view>

#include "pipeline/params/description.h"

namespace inkbench {

enum class WidthUnit { px, percent, world };
template <>
struct ChoiceNames<WidthUnit> {
  static constexpr std::array<std::string_view, 3> names{"px", "percent", "world"};
};

struct LineParams {
  float width = 1.0F;
  WidthUnit unit = WidthUnit::px;
  float taper = 0.0F;
  float depth_taper = 0.0F;
  bool antialias = true;
  bool colour_by_class = false;

  static const Description& description();
};

/// What a drawn line can be of; the values that maps of classes hold.
enum class EdgeClass { none, object, silhouette, crease, normal, shadow, material };
inline constexpr std::array<std::string_view, 7> kEdgeClassNames{"none",   "object", "silhouette", "crease",
                                                                 "normal", "shadow", "material"};
inline constexpr size_t kEdgeClasses = kEdgeClassNames.size() - 1;

/// Of one class.
struct ClassLookParams {
  float width = 1.0F;
  glm::vec3 colour{0.0F};
  float opacity = 1.0F;

  static const Description& description();
};
using ClassLooks = std::array<ClassLookParams, kEdgeClasses>;  ///< From `EdgeClass::object` on.

/// Colours that tell the classes apart, for all readers: Okabe and Ito's.
ClassLooks default_class_looks();

}  // namespace inkbench
