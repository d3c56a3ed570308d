// SPDX-License-Identifier: MIT
// What covers the lines of a view. In: the lines, split where it may change; the models. Out: for each part
// between such places the number of surfaces before it, and what lies behind an outline. Sources: Appel 1967
// (quantitative invisibility), Grabli et al. 2010 (one decision for a part, by a majority of rays).
#pragma once

#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

#include "pipeline/curves/curve_source.h"
#include "pipeline/curves/view_lines.h"

namespace inkbench {

struct CurveModel {
  const CurveSource* source = nullptr;
  glm::dmat4 to_world{1.0}, to_mesh{1.0};
  int object_id = 0;
};

/// A part of a line, from point `from` to point `to`, along which nothing changes.
struct ViewEdge {
  uint32_t line = 0, from = 0, to = 0;
  double length_px = 0.0;
  int covered = 0;
  Behind behind = Behind::unknown;
  bool is_doubtful = false;  ///< No more than half of the rays agree on `covered`.
};

/// Rays against all models.
class Covering {
 public:
  Covering(std::span<const CurveModel> models, const CurveView& view) : models_(models), view_(view) {}

  /// Surfaces between the near plane and a point of the world that do not go through it, and are farther
  /// before it than `apart`, in world units.
  int surfaces_before(const glm::dvec3& world, double apart = 0.0) const;
  /// The object that is seen through a place in pixels at or behind the distance of `nearness`; 0: none.
  int object_behind(const glm::dvec2& pixel, double nearness) const;
  std::span<const CurveModel> models() const { return models_; }
  const CurveView& view() const { return view_; }

 private:
  std::span<const CurveModel> models_;
  const CurveView& view_;
};

/// All lines' parts between changes, line by line; of lines that follow each step. Closed lines are turned so
/// that they start at a change.
std::vector<ViewEdge> view_edges(std::vector<ViewLine>& lines);

/// Decides, for all but lines that follow, `covered` and, of lines along edges that cover, `behind`, by rays
/// to an odd number of places, more on longer parts; parts of less than half a pixel go with their
/// neighbours. On all processors; the result depends on none of that.
void decide_covering(std::span<ViewEdge> edges, const std::vector<ViewLine>& lines, const Covering& covering);

}  // namespace inkbench
