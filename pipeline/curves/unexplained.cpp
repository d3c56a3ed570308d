// SPDX-License-Identifier: MIT
#include "pipeline/curves/unexplained.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "pipeline/lines/line_map.h"

namespace inkbench {
namespace {

/// Which places of the image lie beside visible curves.
class Explained {
 public:
  explicit Explained(const Curves& curves) : near_(kFiner * curves.width_px, kFiner * curves.height_px) {
    for (const Curve& curve : curves.curves) {
      if (curve.covered > 0) continue;
      for (size_t i = 1; i < curve.points.size(); ++i) add(curve.points[i - 1], curve.points[i]);
    }
  }

  bool holds(const glm::vec2& point) const {
    const auto x = static_cast<int>(std::floor(kFiner * point.x));
    const auto y = static_cast<int>(std::floor(kFiner * point.y));
    return near_.contains(x, y) && near_.at(x, y);
  }

 private:
  static constexpr int kFiner = 2;

  void add(const glm::vec2& from, const glm::vec2& to) {
    const float length = glm::distance(from, to);
    const int steps = std::max(1, static_cast<int>(std::ceil(length)));
    for (int i = 0; i <= steps; ++i)
      add_disc(glm::mix(from, to, static_cast<float>(i) / static_cast<float>(steps)));
  }

  void add_disc(const glm::vec2& centre) {
    const float radius = kFiner * kExplainedPx;
    const glm::vec2 at = static_cast<float>(kFiner) * centre;
    for (auto y = static_cast<int>(std::ceil(at.y - radius - 0.5F)); y <= at.y + radius - 0.5F; ++y) {
      const float down = static_cast<float>(y) + 0.5F - at.y;
      const float half = std::sqrt(std::max(radius * radius - down * down, 0.0F));
      for (auto x = static_cast<int>(std::ceil(at.x - half - 0.5F)); x <= at.x + half - 0.5F; ++x) {
        if (near_.contains(x, y)) near_.set(x, y);
      }
    }
  }

  LineMap near_;
};

/// From one point of a curve to another, both included.
Curve part_of(const Curve& curve, size_t from, size_t to) {
  const auto cut = [&](const auto& list) {
    return std::decay_t<decltype(list)>(list.begin() + static_cast<std::ptrdiff_t>(from),
                                        list.begin() + static_cast<std::ptrdiff_t>(to) + 1);
  };
  Curve part = curve;
  part.points = cut(curve.points);
  part.depths = cut(curve.depths);
  part.places = cut(curve.places);
  const bool is_whole = from == 0 && to + 1 == curve.points.size();
  if (from > 0 || (curve.is_closed() && !is_whole)) part.start = CurveEnd::junction;
  if (to + 1 < curve.points.size() || (curve.is_closed() && !is_whole)) part.end = CurveEnd::junction;
  return part;
}

}  // namespace

std::vector<Curve> unexplained(const Curves& traced, const Curves& of_objects) {
  const Explained explained(of_objects);
  std::vector<Curve> rest;
  for (const Curve& curve : traced.curves) {
    for (size_t from = 0; from < curve.points.size(); ++from) {
      if (explained.holds(curve.points[from])) continue;
      size_t to = from;
      while (to + 1 < curve.points.size() && !explained.holds(curve.points[to + 1])) ++to;
      const Curve part = part_of(curve, from, to);
      const bool is_whole = to - from + 1 == curve.points.size();
      if (is_whole || length_px(part) >= kShortestRemainPx) rest.push_back(part);
      from = to;
    }
  }
  return rest;
}

}  // namespace inkbench
