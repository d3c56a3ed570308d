// SPDX-License-Identifier: MIT
#include "pipeline/strokes/dashes.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace inkbench {
namespace {

constexpr float kDotPx = 0.01F;

StrokePoint between(const StrokePoint& a, const StrokePoint& b, float along_px) {
  const float step = b.along_px - a.along_px;
  const float share = step > 0.0F ? (along_px - a.along_px) / step : 0.0F;
  return {glm::mix(a.at, b.at, share), glm::mix(a.radius_px, b.radius_px, share), along_px, a.curve_class};
}

StrokePoint point_of(const Stroke& stroke, float along_px) {
  const std::vector<StrokePoint>& points = stroke.points;
  const auto after =
      std::lower_bound(points.begin() + 1, points.end() - 1, along_px,
                       [](const StrokePoint& point, float along) { return point.along_px < along; });
  return between(*(after - 1), *after, along_px);
}

/// What of the stroke lies between both.
Stroke part_of(const Stroke& stroke, float from_px, float to_px) {
  Stroke part = stroke;
  part.is_closed = false;
  part.points = {point_of(stroke, from_px)};
  for (const StrokePoint& point : stroke.points) {
    if (point.along_px > from_px && point.along_px < to_px) part.points.push_back(point);
  }
  part.points.push_back(point_of(stroke, to_px));
  return part;
}

}  // namespace

std::vector<Stroke> dashes_of(const Stroke& stroke, float dash_px, float gap_px) {
  if (!(gap_px > 0.0F)) return {stroke};
  std::vector<Stroke> dashes;
  const float start = stroke.points.front().along_px, end = stroke.points.back().along_px;
  const float period = dash_px + gap_px;
  for (float begin = std::floor(start / period) * period; begin < end; begin += period) {
    const float from = std::max(begin, start), to = std::min(begin + dash_px, end);
    if (to <= from) continue;
    const float radius =
        std::min(point_of(stroke, 0.5F * (from + to)).radius_px, 0.5F * (to - from - kDotPx));
    if (radius <= 0.0F) continue;
    dashes.push_back(part_of(stroke, from + radius, to - radius));
  }
  return dashes;
}

}  // namespace inkbench
