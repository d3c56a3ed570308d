// SPDX-License-Identifier: MIT
// What a curve can be of: classes that curves, stroke styles and vector files share.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace inkbench {

/// In order of priority: what is of two classes is given as the earlier one. `object`: a silhouette or
/// boundary behind which another object is seen. The last three are of traced lines alone.
enum class CurveClass {
  silhouette,
  boundary,
  object,
  crease,
  intersection,
  suggestive,
  ridge,
  valley,
  apparent_ridge,
  normal,
  shadow,
  material
};
inline constexpr std::array<std::string_view, 12> kCurveClassNames{
    "silhouette", "boundary", "object",         "crease", "intersection", "suggestive",
    "ridge",      "valley",   "apparent_ridge", "normal", "shadow",       "material"};
inline constexpr size_t kCurveClasses = kCurveClassNames.size();

constexpr std::string_view name_of(CurveClass curve_class) {
  return kCurveClassNames[static_cast<size_t>(curve_class)];
}

}  // namespace inkbench
