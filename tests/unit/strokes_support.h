// SPDX-License-Identifier: MIT
// Curves made by hand, for tests of what draws them.
#pragma once

#include <cmath>
#include <vector>

#include "pipeline/strokes/make_strokes.h"

namespace inkbench {

inline Curve make_curve(std::vector<glm::vec2> points, CurveClass curve_class = CurveClass::silhouette) {
  Curve curve{.curve_class = curve_class, .object_id = 1, .points = std::move(points)};
  curve.depths.assign(curve.points.size(), 1.0F);
  for (size_t i = 0; i < curve.points.size(); ++i) curve.places.push_back(0);
  if (curve.is_closed()) curve.start = curve.end = CurveEnd::closed;
  return curve;
}

/// Straight, a point every 10 px, which lie on places from `first_place` on.
inline Curve straight(const glm::vec2& from, const glm::vec2& to, uint64_t first_place = 0) {
  const int steps = std::max(static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / 10.0F), 1);
  std::vector<glm::vec2> points;
  for (int i = 0; i <= steps; ++i)
    points.push_back(from + (to - from) * (static_cast<float>(i) / static_cast<float>(steps)));
  Curve curve = make_curve(std::move(points));
  for (size_t i = 0; i < curve.places.size() && first_place != 0; ++i) curve.places[i] = first_place + i;
  return curve;
}

/// Part of a circle around (100, 100), from and to in degrees; closed where that is all of it.
inline Curve arc(float radius, double from_degrees, double to_degrees, int steps = 360) {
  std::vector<glm::vec2> points;
  for (int i = 0; i <= steps; ++i) {
    const double degrees = from_degrees + (to_degrees - from_degrees) * i / steps;
    const double angle = degrees * 3.14159265358979 / 180.0;
    points.emplace_back(100.0 + radius * std::cos(angle), 100.0 + radius * std::sin(angle));
  }
  if (to_degrees - from_degrees == 360.0) points.back() = points.front();
  return make_curve(std::move(points));
}

inline Curves curves_of(std::vector<Curve> list) {
  Curves curves{200, 200, std::move(list), {}};
  for (size_t i = 0; i < curves.curves.size(); ++i) {
    if (curves.curves[i].chain == 0) curves.curves[i].chain = 1000 + static_cast<uint32_t>(i);
  }
  return curves;
}

inline Strokes strokes_of(std::vector<Curve> list, const StrokeParams& params = {},
                          const StrokeSurroundings& around = {}) {
  return make_strokes(curves_of(std::move(list)), params, default_stroke_classes(), around);
}

}  // namespace inkbench
