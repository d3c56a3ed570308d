// SPDX-License-Identifier: MIT
// Where a pen goes: the course of one stroke before it has a width. What joining, bridging, smoothing and
// sampling hand on.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "pipeline/strokes/stroke.h"

namespace inkbench {

struct PathPoint {
  glm::vec2 at{0.0F};        ///< As `Curve::points`.
  float along_px = 0.0F;     ///< Length of the path up to here, beside what the paint is shifted by.
  float depth = 0.0F;        ///< As `Curve::depths`.
  CurveClass curve_class{};  ///< Of what follows the point.
};

struct StrokePath {
  int object_id = 0;
  int covered = 0;
  bool is_outline = false;
  bool is_traced = false;
  bool is_closed = false;  ///< Then the last point is the first one again.
  CurveEnd start = CurveEnd::free, end = CurveEnd::free;
  uint32_t number = 0;            ///< As `Stroke::number`.
  std::vector<PathPoint> points;  ///< 2 or more, in the order of `along_px`.
  std::vector<PlaceAlong> places;
};

float length_px(const StrokePath& path);

/// Sets each point's `along_px` to the length of the path before it, beginning with 0, and moves `places`
/// with the points that they lie between.
void measure_along(StrokePath& path);

/// The same path from its end to its start; `along_px` still grows from the start on, from where it did.
StrokePath reversed(const StrokePath& path);

/// The path's point at that `along_px`, between points linear; clamped to its ends.
PathPoint point_at(const StrokePath& path, float along_px);

/// Direction in which the path goes there, of length 1, as the chord over `span_px` to both sides has it; a
/// closed path goes on over its start. (1, 0) where it has no length.
glm::vec2 direction_at(const StrokePath& path, float along_px, float span_px);

}  // namespace inkbench
