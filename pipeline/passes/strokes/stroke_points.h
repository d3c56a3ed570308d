// SPDX-License-Identifier: MIT
// Strokes as vertices. In: strokes. Out: one list of points that the renderer reads six at a time: a segment
// with two neighbours on both sides, so that each pixel is painted by the nearest of them alone.
#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "pipeline/strokes/stroke.h"

namespace inkbench {

/// shaders/strokes.vert reads it so.
struct DrawnPoint {
  glm::vec4 place;  ///< x, y, radius, along, px as in `StrokePoint`; radius -1: no stroke goes there.
  glm::vec4 paint;  ///< Seed, a whole number below 2^24; class + 16 flags; the stroke's start and end.
};
inline constexpr int kSegmentFlag = 1, kHiddenFlag = 2, kClosedFlag = 4;
/// Before a segment's own two points.
inline constexpr int kNeighbours = 2;

/// Segment i is between points i + 2 and i + 3, where point i + 2 has the flag. Empty without strokes.
std::vector<DrawnPoint> drawn_points(const Strokes& strokes);

}  // namespace inkbench
