// SPDX-License-Identifier: MIT
#include "pipeline/strokes/sample_path.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace inkbench {
namespace {

float distance_to_piece(const glm::vec2& at, const glm::vec2& a, const glm::vec2& b) {
  const glm::vec2 way = b - a;
  const float square = glm::dot(way, way);
  const float share = square > 0.0F ? glm::clamp(glm::dot(at - a, way) / square, 0.0F, 1.0F) : 0.0F;
  return glm::distance(at, a + share * way);
}

/// The farthest point to which one step from `from` may go.
size_t step_from(const std::vector<PathPoint>& points, size_t from, float longest_px) {
  size_t to = from + 1;
  while (to + 1 < points.size()) {
    if (points[to].curve_class != points[from].curve_class) break;
    if (points[to + 1].along_px - points[from].along_px > longest_px) break;
    for (size_t i = from + 1; i <= to; ++i) {
      if (distance_to_piece(points[i].at, points[from].at, points[to + 1].at) > kSampleErrorPx) return to;
    }
    ++to;
  }
  return to;
}

PathPoint beyond(const StrokePath& path, bool at_start, float by_px) {
  PathPoint end = at_start ? path.points.front() : path.points.back();
  const glm::vec2 direction = direction_at(path, end.along_px, 4.0F);
  const float sign = at_start ? -1.0F : 1.0F;
  end.at += sign * by_px * direction;
  end.along_px += sign * by_px;
  return end;
}

}  // namespace

StrokePath sampled(const StrokePath& path, float longest_px) {
  StrokePath result = path;
  const std::vector<PathPoint>& points = path.points;
  result.points.assign(1, points.front());
  for (size_t from = 0; from + 1 < points.size();) {
    const size_t to = step_from(points, from, longest_px);
    const float length = points[to].along_px - points[from].along_px;
    const int pieces = std::max(static_cast<int>(std::ceil(length / longest_px)), 1);
    for (int i = 1; i < pieces; ++i) {
      const float share = static_cast<float>(i) / static_cast<float>(pieces);
      result.points.push_back(point_at(path, points[from].along_px + share * length));
    }
    result.points.push_back(points[to]);
    from = to;
  }
  return result;
}

void overshoot(StrokePath& path, float by_px) {
  if (!(by_px > 0.0F) || path.is_closed || length_px(path) <= 0.0F) return;
  const PathPoint before = beyond(path, true, by_px), after = beyond(path, false, by_px);
  if (path.start != CurveEnd::frame) path.points.insert(path.points.begin(), before);
  if (path.end != CurveEnd::frame) path.points.push_back(after);
}

}  // namespace inkbench
