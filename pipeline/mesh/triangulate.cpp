// SPDX-License-Identifier: MIT
#include "pipeline/mesh/triangulate.h"
#include "pipeline/mesh/triangle_edges.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numeric>

namespace inkbench {
namespace {

/// Twice the area as a vector. The products of differences of floats are exact in double but for the last
/// subtraction, so three corners on a line give zero.
glm::dvec3 area_vector(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return glm::cross(b - a, c - a);
}

bool has_area(const glm::dvec3& area) {
  return area.x != 0.0 || area.y != 0.0 || area.z != 0.0;
}

glm::dvec3 polygon_area(std::span<const glm::dvec3> corners) {
  glm::dvec3 sum(0.0);
  for (size_t i = 1; i + 1 < corners.size(); ++i) sum += area_vector(corners[0], corners[i], corners[i + 1]);
  return sum;
}

bool add(std::span<const glm::dvec3> corners, const Triangle& t, std::vector<Triangle>& triangles) {
  if (!has_area(area_vector(corners[t[0]], corners[t[1]], corners[t[2]]))) return false;
  triangles.push_back(t);
  return true;
}

/// A quadrilateral by the diagonal that leaves both triangles facing its way, the one from corner 0 first.
Triangulation cut_quadrilateral(std::span<const glm::dvec3> corners, std::vector<Triangle>& triangles) {
  const glm::dvec3 way = polygon_area(corners);
  const auto faces_way = [&](const Triangle& t) {
    return glm::dot(area_vector(corners[t[0]], corners[t[1]], corners[t[2]]), way) > 0.0;
  };
  constexpr std::array<std::array<Triangle, 2>, 2> kCuts{
      {{{{0, 1, 2}, {0, 2, 3}}}, {{{1, 2, 3}, {1, 3, 0}}}}};
  const bool first = faces_way(kCuts[0][0]) && faces_way(kCuts[0][1]);
  const bool second = !first && faces_way(kCuts[1][0]) && faces_way(kCuts[1][1]);
  bool any = false;
  for (const Triangle& t : kCuts[second ? 1 : 0]) any = add(corners, t, triangles) || any;
  if (!any) return Triangulation::no_area;
  return first || second ? Triangulation::clean : Triangulation::crossed;
}

double area_of(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The corners without the coordinate along which the polygon faces most, counter-clockwise: no coordinate is
/// rounded.
std::vector<glm::dvec2> flattened(std::span<const glm::dvec3> corners, const glm::dvec3& way) {
  const glm::dvec3 size = glm::abs(way);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const int u = way[axis] > 0.0 ? (axis + 1) % 3 : (axis + 2) % 3;
  const int v = 3 - axis - u;
  std::vector<glm::dvec2> flat;
  flat.reserve(corners.size());
  for (const glm::dvec3& corner : corners) flat.emplace_back(corner[u], corner[v]);
  return flat;
}

/// The corners that may lie in an ear, by squares of a grid: those that are not convex.
class CornerGrid {
 public:
  CornerGrid(std::span<const glm::dvec2> corners, const std::vector<uint32_t>& members) {
    low_ = high_ = corners[0];
    for (const glm::dvec2& corner : corners) {
      low_ = glm::min(low_, corner);
      high_ = glm::max(high_, corner);
    }
    side_ = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(members.size()))), 1, 1024);
    cells_.resize(static_cast<size_t>(side_) * side_);
    for (const uint32_t member : members) {
      const auto [x, y] = cell_of(corners[member]);
      cells_[static_cast<size_t>(y) * side_ + x].push_back(member);
    }
  }

  /// Whether `test` holds for a member in the squares between two places.
  template <class Test>
  bool any_between(const glm::dvec2& low, const glm::dvec2& high, const Test& test) const {
    const auto [x0, y0] = cell_of(low);
    const auto [x1, y1] = cell_of(high);
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        if (std::ranges::any_of(cells_[static_cast<size_t>(y) * side_ + x], test)) return true;
      }
    }
    return false;
  }

 private:
  std::pair<int, int> cell_of(const glm::dvec2& place) const {
    const auto along = [&](double value, double low, double high) {
      const double share = high > low ? (value - low) / (high - low) : 0.0;
      return std::clamp(static_cast<int>(share * side_), 0, side_ - 1);
    };
    return {along(place.x, low_.x, high_.x), along(place.y, low_.y, high_.y)};
  }

  glm::dvec2 low_, high_;
  int side_ = 1;
  std::vector<std::vector<uint32_t>> cells_;
};

/// Cuts ears off until three corners are left. After an ear, the next corner but one is tried, so that
/// the cuts go round the polygon instead of making a fan.
class EarClipper {
 public:
  explicit EarClipper(std::vector<glm::dvec2> corners)
      : corners_(std::move(corners)),
        before_(corners_.size()),
        after_(corners_.size()),
        gone_(corners_.size(), false),
        grid_(corners_, link_and_find_blunt()) {}

  /// False where the triangles do not cover each part of the polygon once.
  bool run(std::vector<Triangle>& triangles) {
    uint32_t corner = 0;
    size_t left = corners_.size(), misses = 0;
    Rule rule = Rule::closed;
    bool is_forced = false;
    double covered = 0.0, area = 0.0;
    while (left >= 3) {
      if (left > 3 && !is_ear(corner, rule)) {
        corner = after_[corner];
        if (++misses < left) continue;
        misses = 0;
        rule = rule == Rule::closed ? Rule::open : Rule::any;
        continue;
      }
      triangles.push_back({before_[corner], corner, after_[corner]});
      is_forced = is_forced || rule == Rule::any;
      covered += std::abs(turn_at(corner));
      area += turn_at(corner);
      corner = cut(corner);
      --left;
      misses = 0;
      rule = Rule::closed;
    }
    return !is_forced && covered <= area * (1.0 + 1e-9);
  }

 private:
  /// What keeps a corner from being an ear: another corner in it or on its border; in it; nothing.
  enum class Rule { closed, open, any };

  double turn_at(uint32_t corner) const {
    return area_of(corners_[before_[corner]], corners_[corner], corners_[after_[corner]]);
  }

  std::vector<uint32_t> link_and_find_blunt() {
    const auto count = static_cast<uint32_t>(corners_.size());
    for (uint32_t i = 0; i < count; ++i) {
      before_[i] = (i + count - 1) % count;
      after_[i] = (i + 1) % count;
    }
    std::vector<uint32_t> blunt;
    for (uint32_t i = 0; i < count; ++i) {
      if (turn_at(i) <= 0.0) blunt.push_back(i);
    }
    return blunt;
  }

  bool is_ear(uint32_t corner, Rule rule) const {
    if (rule == Rule::any) return true;
    if (!(turn_at(corner) > 0.0)) return false;
    const glm::dvec2 &a = corners_[before_[corner]], &b = corners_[corner], &c = corners_[after_[corner]];
    const auto is_in_the_way = [&](uint32_t other) {
      const glm::dvec2& p = corners_[other];
      if (gone_[other] || p == a || p == b || p == c) return false;
      const double least = std::min({area_of(a, b, p), area_of(b, c, p), area_of(c, a, p)});
      return rule == Rule::closed ? least >= 0.0 : least > 0.0;
    };
    return !grid_.any_between(glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c), is_in_the_way);
  }

  /// Returns where to go on.
  uint32_t cut(uint32_t corner) {
    gone_[corner] = true;
    after_[before_[corner]] = after_[corner];
    before_[after_[corner]] = before_[corner];
    return after_[after_[corner]];
  }

  std::vector<glm::dvec2> corners_;
  std::vector<uint32_t> before_, after_;
  std::vector<bool> gone_;
  CornerGrid grid_;
};

Triangulation clip_ears(std::span<const glm::dvec3> corners, std::vector<Triangle>& triangles) {
  const glm::dvec3 way = polygon_area(corners);
  const size_t before = triangles.size();
  std::vector<Triangle> ears;
  const bool clean = has_area(way) && EarClipper(flattened(corners, way)).run(ears);
  if (!has_area(way)) {  // a figure of eight, or a line
    for (uint32_t i = 1; i + 1 < corners.size(); ++i) ears.push_back({0, i, i + 1});
  }
  for (const Triangle& t : ears) add(corners, t, triangles);
  if (triangles.size() == before) return Triangulation::no_area;
  return clean ? Triangulation::clean : Triangulation::crossed;
}

}  // namespace

Triangulation triangulate(std::span<const glm::dvec3> corners, std::vector<Triangle>& triangles) {
  if (corners.size() < 3) return Triangulation::no_area;
  if (corners.size() == 3)
    return add(corners, {0, 1, 2}, triangles) ? Triangulation::clean : Triangulation::no_area;
  return corners.size() == 4 ? cut_quadrilateral(corners, triangles) : clip_ears(corners, triangles);
}

}  // namespace inkbench
