// SPDX-License-Identifier: MIT
#include "pipeline/strokes/stroke_path.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace inkbench {
namespace {

/// On a closed path what lies beyond one end lies behind the other one.
float wrapped(const StrokePath& path, float along_px) {
  const float start = path.points.front().along_px, end = path.points.back().along_px;
  if (!path.is_closed || end <= start) return along_px;
  if (along_px < start) return along_px + (end - start);
  return along_px > end ? along_px - (end - start) : along_px;
}

void move_places(StrokePath& path, const std::vector<PathPoint>& before) {
  size_t next = 1;
  for (PlaceAlong& place : path.places) {
    while (next + 1 < before.size() && before[next].along_px < place.along_px) ++next;
    const float from = before[next - 1].along_px, step = before[next].along_px - from;
    const float share = step > 0.0F ? std::clamp((place.along_px - from) / step, 0.0F, 1.0F) : 0.0F;
    const float start = path.points[next - 1].along_px;
    place.along_px = start + share * (path.points[next].along_px - start);
  }
}

}  // namespace

float length_px(const StrokePath& path) {
  return path.points.back().along_px - path.points.front().along_px;
}

void measure_along(StrokePath& path) {
  const std::vector<PathPoint> before = path.points;
  double along = 0.0;
  path.points.front().along_px = 0.0F;
  for (size_t i = 1; i < path.points.size(); ++i) {
    along += glm::distance(glm::dvec2(path.points[i - 1].at), glm::dvec2(path.points[i].at));
    path.points[i].along_px = static_cast<float>(along);
  }
  move_places(path, before);
}

StrokePath reversed(const StrokePath& path) {
  StrokePath turned = path;
  const float sum = path.points.front().along_px + path.points.back().along_px;
  std::reverse(turned.points.begin(), turned.points.end());
  for (size_t i = 0; i < turned.points.size(); ++i) {
    turned.points[i].along_px = sum - turned.points[i].along_px;
    // What followed a point now comes before it.
    const size_t following = i + 1 < turned.points.size() ? i + 1 : i;
    turned.points[i].curve_class = path.points[path.points.size() - 1 - following].curve_class;
  }
  std::reverse(turned.places.begin(), turned.places.end());
  for (PlaceAlong& place : turned.places) place.along_px = sum - place.along_px;
  std::swap(turned.start, turned.end);
  return turned;
}

PathPoint point_at(const StrokePath& path, float along_px) {
  const std::vector<PathPoint>& points = path.points;
  const auto after = std::upper_bound(points.begin(), points.end(), along_px,
                                      [](float at, const PathPoint& point) { return at < point.along_px; });
  if (after == points.begin()) return points.front();
  if (after == points.end()) return points.back();
  const PathPoint &a = *(after - 1), &b = *after;
  const float share = (along_px - a.along_px) / (b.along_px - a.along_px);
  const bool is_known = a.depth > 0.0F && b.depth > 0.0F;
  return {glm::mix(a.at, b.at, share), along_px,
          is_known ? glm::mix(a.depth, b.depth, share) : std::max(a.depth, b.depth), a.curve_class};
}

glm::vec2 direction_at(const StrokePath& path, float along_px, float span_px) {
  const glm::vec2 chord = point_at(path, wrapped(path, along_px + span_px)).at -
                          point_at(path, wrapped(path, along_px - span_px)).at;
  const float length = glm::length(chord);
  return length > 0.0F ? chord / length : glm::vec2(1.0F, 0.0F);
}

}  // namespace inkbench
