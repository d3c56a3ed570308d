// SPDX-License-Identifier: MIT
#include "pipeline/curves/cusps.h"

#include <algorithm>

namespace inkbench {
namespace {

double cross_2d(const glm::dvec3& a, const glm::dvec3& b) {
  return a.x * b.y - a.y * b.x;
}

/// A face's corners in pixels, as seen from one of them.
class RingFace {
 public:
  RingFace(const glm::dvec3& middle, const glm::dvec3& next, const glm::dvec3& last)
      : u_(next - middle), v_(last - middle), area_(cross_2d(u_, v_)) {}

  /// Whether it lies before the way from its corner to `end`.
  bool covers(const glm::dvec3& middle, const glm::dvec3& end) const {
    if (area_ == 0.0) return false;
    const glm::dvec3 way = end - middle;
    const double along_u = cross_2d(way, v_) / area_;
    const double along_v = cross_2d(u_, way) / area_;
    if (along_u <= 0.0 || along_v <= 0.0) return false;
    return along_u * u_.z + along_v * v_.z > way.z;
  }

 private:
  glm::dvec3 u_, v_;
  double area_;
};

class CuspFinder {
 public:
  CuspFinder(const CurveSource& source, const glm::dmat4& to_world, const CurveView& view)
      : source_(source), to_world_(to_world), view_(view) {}

  /// `before` and `after` are the steps that meet in the edges' common point.
  bool is_cusp(uint32_t before, uint32_t after) {
    const auto& a = source_.topology().edges[before].points;
    const auto& b = source_.topology().edges[after].points;
    const uint32_t middle = a[0] == b[0] || a[0] == b[1] ? a[0] : a[1];
    return faces_before(middle, a[0] == middle ? a[1] : a[0]) !=
           faces_before(middle, b[0] == middle ? b[1] : b[0]);
  }

 private:
  glm::dvec3 pixel(uint32_t point, bool& in_front) const {
    const glm::dvec4 clip =
        view_.to_clip(glm::dvec3(to_world_ * glm::dvec4(source_.topology().positions[point], 1.0)));
    in_front = in_front && clip.w > 0.0;
    return view_.to_pixel(clip);
  }

  int faces_before(uint32_t middle, uint32_t end) const {
    int count = 0;
    bool in_front = true;
    const glm::dvec3 at_middle = pixel(middle, in_front);
    const glm::dvec3 at_end = pixel(end, in_front);
    for (const uint32_t face : source_.rings().around(middle)) {
      const auto& corners = source_.topology().faces[face];
      if (std::find(corners.begin(), corners.end(), end) != corners.end()) continue;
      const auto at =
          static_cast<size_t>(std::find(corners.begin(), corners.end(), middle) - corners.begin());
      const RingFace ring(at_middle, pixel(corners[(at + 1) % 3], in_front),
                          pixel(corners[(at + 2) % 3], in_front));
      if (ring.covers(at_middle, at_end)) ++count;
    }
    return in_front ? count : 0;
  }

  const CurveSource& source_;
  const glm::dmat4& to_world_;
  const CurveView& view_;
};

}  // namespace

void mark_cusps(const CurveSource& source, const glm::dmat4& to_world, const CurveView& view,
                ViewLine& line) {
  CuspFinder finder(source, to_world, view);
  const auto is_cusp = [&](size_t before, size_t after) {
    const uint32_t a = line.steps[before].edge;
    const uint32_t b = line.steps[after].edge;
    return a != LineStep::kNone && b != LineStep::kNone && a != b && finder.is_cusp(a, b);
  };
  for (size_t i = 1; i < line.steps.size(); ++i) {
    if (!line.points[i].change && is_cusp(i - 1, i)) line.points[i].change = CurveEnd::cusp;
  }
  if (line.is_closed && !line.points[0].change && is_cusp(line.steps.size() - 1, 0))
    line.points.front().change = line.points.back().change = CurveEnd::cusp;
}

}  // namespace inkbench
