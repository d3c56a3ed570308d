// SPDX-License-Identifier: MIT
// Strokes of one view: curves with a width, where a pen would draw. In pixel space. What is drawn by OpenGL
// and written as vectors.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "pipeline/curves/curve.h"

namespace inkbench {

struct StrokePoint {
  glm::vec2 at{0.0F};        ///< As `Curve::points`.
  float radius_px = 0.0F;    ///< Half the width; between points it is linear.
  float along_px = 0.0F;     ///< Where the paint is taken from: grows by what the stroke is long.
  CurveClass curve_class{};  ///< Of what follows the point; a stroke may go on through several.
};

/// Where on a stroke something of a mesh lies (`Curve::places`).
struct PlaceAlong {
  uint64_t place = 0;
  float along_px = 0.0F;

  bool operator==(const PlaceAlong&) const = default;
};

/// A whole stroke, before it is drawn several times or cut into dashes: what the next frame takes its paint's
/// places from (carry_along.h).
struct StrokeCourse {
  uint32_t number = 0;
  bool is_closed = false;
  float start_px = 0.0F, end_px = 0.0F;  ///< `along_px` of its ends.
  std::vector<PlaceAlong> places;        ///< In the order of `along_px`.
};

/// All points whose distance from one of its points p(t) is at most r(t): the union of the discs along it, so
/// that joins and caps are round.
struct Stroke {
  int object_id = 0;
  int covered = 0;          ///< By how many surfaces; hidden strokes are dashes already.
  bool is_outline = false;  ///< Another object or nothing lies behind most of it.
  uint32_t number = 0;      ///< In what the paint's randomness is; equal for what is the same stroke.
  int pass = 0;             ///< Of `stroke.passes`.
  float start_px = 0.0F, end_px = 0.0F;  ///< The whole stroke's `along_px`, of which dashes are parts.
  std::vector<StrokePoint> points;       ///< 2 or more; a closed stroke repeats its first point at the end.
  bool is_closed = false;
};

struct Strokes {
  int width_px = 0, height_px = 0;
  std::vector<Stroke> strokes;  ///< In the order in which they are drawn.
  std::vector<StrokeCourse> courses;
};

}  // namespace inkbench
