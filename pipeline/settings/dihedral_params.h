// SPDX-License-Identifier: MIT
// The numbers of the detector `dihedral`: by what angle and what gap neighbouring pixels are two surfaces.
#pragma once

#include <array>
#include <string_view>

#include "pipeline/params/description.h"

namespace inkbench {

/// Whose normals a bend is measured by: the triangles' own, those that light sees, or whichever bend more.
enum class BendNormals { surface, shading, both };
template <>
struct ChoiceNames<BendNormals> {
  static constexpr std::array<std::string_view, 3> names{"surface", "shading", "both"};
};

/// The largest limit of a gap: no gap within one object reaches it.
inline constexpr float kMostGap = 50000.0F;

struct DihedralParams {
  float angle = 40.0F;
  float gap = 0.5F;
  BendNormals normals = BendNormals::surface;

  static const Description& description();
};

}  // namespace inkbench
