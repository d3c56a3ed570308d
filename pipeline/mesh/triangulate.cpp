// SPDX-License-Identifier: MIT
#include "pipeline/mesh/triangulate.h"

#include <glm/geometric.hpp>

namespace inkbench {
namespace {

/// Trying every start is quadratic; polygons beyond this many corners take the first.
constexpr size_t kMaxSearchedCorners = 64;

/// Twice the area as a vector. In double the products of float differences are exact but for the last
/// subtraction, so three corners on a line give zero.
glm::dvec3 area_vector(std::span<const glm::vec3> points, int32_t a, int32_t b, int32_t c) {
  const glm::dvec3 origin = points[a];
  return glm::cross(glm::dvec3(points[b]) - origin, glm::dvec3(points[c]) - origin);
}

bool has_area(const glm::dvec3& area) {
  return area.x != 0.0 || area.y != 0.0 || area.z != 0.0;
}

struct Fan {
  std::span<const int32_t> polygon;
  size_t start = 0;

  size_t triangle_count() const { return polygon.size() - 2; }
  std::array<int32_t, 3> triangle(size_t index) const {
    const size_t n = polygon.size();
    return {polygon[start], polygon[(start + index + 1) % n], polygon[(start + index + 2) % n]};
  }
};

glm::dvec3 polygon_area(std::span<const glm::vec3> points, const Fan& fan) {
  glm::dvec3 sum(0.0);
  for (size_t i = 0; i < fan.triangle_count(); ++i) {
    const auto [a, b, c] = fan.triangle(i);
    sum += area_vector(points, a, b, c);
  }
  return sum;
}

bool faces_one_way(std::span<const glm::vec3> points, const Fan& fan, const glm::dvec3& way) {
  for (size_t i = 0; i < fan.triangle_count(); ++i) {
    const auto [a, b, c] = fan.triangle(i);
    if (!(glm::dot(area_vector(points, a, b, c), way) > 0.0)) return false;
  }
  return true;
}

Fan best_fan(std::span<const glm::vec3> points, std::span<const int32_t> polygon) {
  Fan fan{polygon};
  if (polygon.size() == 3 || polygon.size() > kMaxSearchedCorners) return fan;
  const glm::dvec3 way = polygon_area(points, fan);
  for (fan.start = 0; fan.start < polygon.size(); ++fan.start) {
    if (faces_one_way(points, fan, way)) return fan;
  }
  fan.start = 0;
  return fan;
}

}  // namespace

bool triangulate(std::span<const glm::vec3> points, std::span<const int32_t> polygon,
                 std::vector<std::array<uint32_t, 3>>& triangles) {
  if (polygon.size() < 3) return false;
  const size_t before = triangles.size();
  const Fan fan = best_fan(points, polygon);
  for (size_t i = 0; i < fan.triangle_count(); ++i) {
    const auto [a, b, c] = fan.triangle(i);
    if (!has_area(area_vector(points, a, b, c))) continue;
    triangles.push_back({static_cast<uint32_t>(a), static_cast<uint32_t>(b), static_cast<uint32_t>(c)});
  }
  return triangles.size() > before;
}

}  // namespace inkbench
