// SPDX-License-Identifier: MIT
// Reference lines: the lines that a perfect edge filter would draw, by class, as polylines. What extraction
// puts out and what the measures, the `reference` buffer and the SVG writer read.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

#include "pipeline/settings/judge_params.h"

namespace inkbench {

/// In order of priority: an edge that is of two classes is given as the earlier one.
enum class LineClass { silhouette, boundary, crease, object, suggestive, ridge, valley };

constexpr std::array<std::string_view, 7> kLineClassNames{"silhouette", "boundary", "crease", "object",
                                                          "suggestive", "ridge",    "valley"};
constexpr std::array<LineClass, 7> kLineClasses{
    LineClass::silhouette, LineClass::boundary, LineClass::crease, LineClass::object,
    LineClass::suggestive, LineClass::ridge,    LineClass::valley};

constexpr std::string_view name_of(LineClass line_class) {
  return kLineClassNames[static_cast<size_t>(line_class)];
}

/// In the order of `kLineClasses`.
constexpr std::array<Demand JudgeParams::*, kLineClasses.size()> kDemands{
    &JudgeParams::silhouette, &JudgeParams::boundary, &JudgeParams::crease, &JudgeParams::object,
    &JudgeParams::suggestive, &JudgeParams::ridge,    &JudgeParams::valley};

/// 1: lines that a drawing must have. 2: lines that it may have.
constexpr int tier(const JudgeParams& judge, LineClass line_class) {
  return judge.*kDemands[static_cast<size_t>(line_class)] == Demand::wanted ? 1 : 2;
}

/// A visible line in pixel space: x right, y down, the image is [0, W] x [0, H], pixel centres at + 0.5.
struct Polyline {
  LineClass line_class = LineClass::silhouette;
  int object_id = 0;              ///< As in the object-id buffer; of an `object` line, the nearer object.
  std::vector<glm::vec2> points;  ///< 2 or more; a closed line repeats its first point at the end.

  bool operator==(const Polyline&) const = default;
};

/// A line through the faces of a smooth surface (smooth_surface.h), hidden parts included, in its space.
struct SurfaceLine {
  std::vector<glm::dvec3> points;  ///< 2 or more; a closed line repeats its first point at the end.
  std::vector<uint32_t>
      crossings;                ///< For each point the edge that it lies on, as `SmoothSurface::crossings`
                                ///< numbers them; from `crossing_count` on: in the middle of a face.
  std::vector<uint32_t> faces;  ///< From each point to the next: the face that the line runs through.
};

/// A line in the space of a mesh, hidden parts included.
struct Polyline3 {
  LineClass line_class = LineClass::silhouette;
  std::vector<glm::dvec3> points;          ///< 2 or more; a closed line repeats its first point at the end.
  std::vector<uint32_t> crossings, faces;  ///< Of lines of a smooth surface: as a `SurfaceLine`'s.
};

}  // namespace inkbench
