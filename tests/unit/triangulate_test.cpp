// SPDX-License-Identifier: MIT
// Polygons of any outline become triangles that cover them once.
#include "pipeline/mesh/triangulate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>

namespace inkbench {
namespace {

using Corners = std::vector<glm::dvec3>;
using Triangles = std::vector<std::array<uint32_t, 3>>;

double area_sum(const Corners& corners, const Triangles& triangles) {
  double sum = 0.0;
  for (const auto& [a, b, c] : triangles)
    sum += 0.5 * glm::length(glm::cross(corners[b] - corners[a], corners[c] - corners[a]));
  return sum;
}

/// On a circle, every other corner drawn in to `inner`.
Corners star(int count, double inner) {
  Corners corners;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count, radius = i % 2 == 0 ? 1.0 : inner;
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.3 * radius * std::cos(angle));
  }
  return corners;
}

double polygon_area(const Corners& corners) {
  glm::dvec3 sum(0.0);
  for (size_t i = 0; i < corners.size(); ++i)
    sum += glm::cross(corners[i], corners[(i + 1) % corners.size()]);
  return 0.5 * glm::length(sum);
}

TEST(Triangulate, concave_polygons_are_covered_once_whatever_their_first_corner) {
  for (const int count : {5, 8, 100, 1000}) {
    const Corners whole = star(count - count % 2, 0.3);
    for (size_t start = 0; start < whole.size(); start += 1 + whole.size() / 7) {
      Corners corners(whole.begin() + static_cast<ptrdiff_t>(start), whole.end());
      corners.insert(corners.end(), whole.begin(), whole.begin() + static_cast<ptrdiff_t>(start));
      Triangles triangles;
      EXPECT_EQ(triangulate(corners, triangles), Triangulation::clean) << count;
      EXPECT_EQ(triangles.size(), corners.size() - 2);
      EXPECT_NEAR(area_sum(corners, triangles), polygon_area(corners), 1e-9) << count << " from " << start;
    }
  }
}

TEST(Triangulate, a_hole_joined_by_a_bridge_stays_open) {
  const Corners corners{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                        {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
  Triangles triangles;
  EXPECT_EQ(triangulate(corners, triangles), Triangulation::clean);
  EXPECT_NEAR(area_sum(corners, triangles), 12.0, 1e-12);
  for (const auto& [a, b, c] : triangles) {
    const glm::dvec3 middle = (corners[a] + corners[b] + corners[c]) / 3.0;
    EXPECT_FALSE(middle.x > 1 && middle.x < 3 && middle.y > 1 && middle.y < 3);
  }
}

TEST(Triangulate, no_corner_of_a_large_convex_polygon_gets_many_triangles) {
  const Corners corners = star(2000, 1.0);
  Triangles triangles;
  EXPECT_EQ(triangulate(corners, triangles), Triangulation::clean);
  std::map<uint32_t, int> uses;
  for (const auto& triangle : triangles) {
    for (const uint32_t corner : triangle) ++uses[corner];
  }
  for (const auto& [corner, count] : uses) EXPECT_LE(count, 24) << corner;
}

TEST(Triangulate, a_corner_in_the_middle_of_a_side_is_a_corner_of_a_triangle_wherever_it_stands) {
  const Corners whole{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {0, 2, 0}};
  for (size_t start = 0; start < whole.size(); ++start) {
    Corners corners;
    for (size_t i = 0; i < whole.size(); ++i) corners.push_back(whole[(start + i) % whole.size()]);
    Triangles triangles;
    EXPECT_EQ(triangulate(corners, triangles), Triangulation::clean);
    EXPECT_EQ(triangles.size(), 4U) << start;
    EXPECT_NEAR(area_sum(corners, triangles), 4.0, 1e-12);
  }
}

TEST(Triangulate, what_crosses_itself_is_told_and_what_has_no_area_gives_nothing) {
  Triangles triangles;
  EXPECT_EQ(triangulate(Corners{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 1, 0}}, triangles),
            Triangulation::crossed);
  Corners pentagram;
  for (int i = 0; i < 5; ++i)
    pentagram.emplace_back(std::cos(0.8 * std::numbers::pi * i), std::sin(0.8 * std::numbers::pi * i), 0.0);
  EXPECT_EQ(triangulate(pentagram, triangles), Triangulation::crossed);
  triangles.clear();
  EXPECT_EQ(triangulate(Corners{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5, 0, 0}}, triangles),
            Triangulation::no_area);
  EXPECT_TRUE(triangles.empty());
}

}  // namespace
}  // namespace inkbench
