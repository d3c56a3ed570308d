// SPDX-License-Identifier: MIT
#include "app/workbench/nearest_curve.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

namespace inkbench {
namespace {

float distance_px(glm::vec2 point, glm::vec2 from, glm::vec2 to) {
  const glm::vec2 way = to - from;
  const float square = glm::dot(way, way);
  const float share = square > 0.0F ? std::clamp(glm::dot(point - from, way) / square, 0.0F, 1.0F) : 0.0F;
  return glm::distance(point, from + share * way);
}

float distance_px(glm::vec2 point, const Curve& curve) {
  float least = std::numeric_limits<float>::infinity();
  for (size_t i = 1; i < curve.points.size(); ++i)
    least = std::min(least, distance_px(point, curve.points[i - 1], curve.points[i]));
  return least;
}

}  // namespace

std::optional<size_t> nearest_curve(const Curves& curves, glm::vec2 point, float radius_px,
                                    bool with_hidden) {
  std::optional<size_t> nearest;
  float least = radius_px;
  for (size_t i = 0; i < curves.curves.size(); ++i) {
    const Curve& curve = curves.curves[i];
    const bool is_hidden = curve.covered > 0;
    if (is_hidden && !with_hidden) continue;
    const float distance = distance_px(point, curve);
    const bool wins_tie = !nearest || (!is_hidden && curves.curves[*nearest].covered > 0);
    if (distance > least || (distance == least && !wins_tie)) continue;
    least = distance;
    nearest = i;
  }
  return nearest;
}

}  // namespace inkbench
