// SPDX-License-Identifier: MIT
#include "pipeline/curves/cusps.h"

#include <algorithm>
#include <array>

#include "pipeline/base/parallel.h"

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
  CuspFinder(const CurveModel& model, const CurveView& view)
      : source_(*model.source), to_world_(model.to_world), view_(view) {}

  /// `before` and `after` are the steps that meet in the edges' common point.
  bool is_cusp(uint32_t before, uint32_t after) const {
    const auto& a = source_.topology().edges[before].points;
    const auto& b = source_.topology().edges[after].points;
    const uint32_t middle = a[0] == b[0] || a[0] == b[1] ? a[0] : a[1];
    const std::array<uint32_t, 2> ends{a[0] == middle ? a[1] : a[0], b[0] == middle ? b[1] : b[0]};
    bool in_front = true;
    const glm::dvec3 at_middle = pixel(middle, in_front);
    const std::array<glm::dvec3, 2> at_ends{pixel(ends[0], in_front), pixel(ends[1], in_front)};
    std::array<int, 2> faces_before{};
    for (const uint32_t face : source_.rings().around(middle)) {
      const auto& corners = source_.topology().faces[face];
      const auto at =
          static_cast<size_t>(std::find(corners.begin(), corners.end(), middle) - corners.begin());
      const uint32_t next = corners[(at + 1) % 3];
      const uint32_t last = corners[(at + 2) % 3];
      const RingFace ring(at_middle, pixel(next, in_front), pixel(last, in_front));
      for (size_t i = 0; i < 2; ++i) {
        if (next != ends[i] && last != ends[i] && ring.covers(at_middle, at_ends[i])) ++faces_before[i];
      }
    }
    return in_front && faces_before[0] != faces_before[1];
  }

 private:
  glm::dvec3 pixel(uint32_t point, bool& in_front) const {
    const glm::dvec4 clip =
        view_.to_clip(glm::dvec3(to_world_ * glm::dvec4(source_.topology().positions[point], 1.0)));
    in_front = in_front && clip.w > 0.0;
    return view_.to_pixel(clip);
  }

  const CurveSource& source_;
  const glm::dmat4& to_world_;
  const CurveView& view_;
};

}  // namespace

void mark_cusps(std::span<const CurveModel> models, const CurveView& view, std::vector<ViewLine>& lines) {
  struct Vertex {
    uint32_t line = 0, before = 0, after = 0;  // steps
  };
  std::vector<Vertex> vertices;
  for (uint32_t i = 0; i < lines.size(); ++i) {
    const ViewLine& line = lines[i];
    if (!line.covers) continue;
    const auto count = static_cast<uint32_t>(line.steps.size());
    for (uint32_t at = line.is_closed ? 0 : 1; at < count; ++at) {
      const uint32_t before = (at + count - 1) % count;
      if (!line.points[at].change && line.steps[before].edge != line.steps[at].edge)
        vertices.push_back({i, before, at});
    }
  }
  for_each_in_parallel(vertices.size(), [&](size_t i) {
    const Vertex& vertex = vertices[i];
    ViewLine& line = lines[vertex.line];
    const CuspFinder finder(models[static_cast<size_t>(line.model)], view);
    if (finder.is_cusp(line.steps[vertex.before].edge, line.steps[vertex.after].edge))
      line.points[vertex.after].change = CurveEnd::cusp;
  });
  for (ViewLine& line : lines) {
    if (line.is_closed) line.points.back().change = line.points.front().change;
  }
}

}  // namespace inkbench
