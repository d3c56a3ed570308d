// SPDX-License-Identifier: MIT
// View-dependent curvature and its ridges on surfaces where both are known, and the size of features.
#include "pipeline/lines/apparent_ridges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

#include "pipeline/curves/feature_size.h"
#include "pipeline/mesh/shapes/primitives.h"

namespace inkbench {
namespace {

SmoothSurface smooth_surface_of(const Mesh& mesh, const glm::dmat3& stretch = glm::dmat3(1.0)) {
  return make_smooth_surface(make_topology(mesh), 60.0, 0.0, stretch);
}

/// x^2 / a^2 + y^2 / b^2 + z^2 / c^2 = 1.
constexpr glm::dvec3 kHalfAxes{1.0, 0.7, 1.4};

glm::dvec3 ellipsoid_normal(const glm::dvec3& p) {
  return glm::normalize(p / (kHalfAxes * kHalfAxes));
}

SymmetricTensor ellipsoid_curvature(const glm::dvec3& p) {
  const glm::dvec3 n = ellipsoid_normal(p);
  const double length = glm::length(p / (kHalfAxes * kHalfAxes));
  const glm::dvec3 bend = 1.0 / (kHalfAxes * kHalfAxes * length);
  const auto at = [&](int i, int j) {  // (I - n n^T) diag(bend) (I - n n^T)
    double sum = 0.0;
    for (int k = 0; k < 3; ++k)
      sum += ((i == k ? 1.0 : 0.0) - n[i] * n[k]) * bend[k] * ((j == k ? 1.0 : 0.0) - n[j] * n[k]);
    return sum;
  };
  return {at(0, 0), at(0, 1), at(0, 2), at(1, 1), at(1, 2), at(2, 2)};
}

/// Where the line of sight along `view` through `p` meets the ellipsoid next to `p`.
glm::dvec3 seen_near(const glm::dvec3& p, const glm::dvec3& view) {
  const glm::dvec3 scaled = p / kHalfAxes, along = view / kHalfAxes;
  const double a = glm::dot(along, along), b = glm::dot(scaled, along), c = glm::dot(scaled, scaled) - 1.0;
  const double root = std::sqrt(b * b - a * c);
  const double t = (b > 0.0 ? -b + root : -b - root) / a;
  return p + t * view;
}

TEST(ApparentCurvature, is_the_largest_turn_of_the_normal_for_a_step_in_the_picture) {
  const glm::dvec3 view = glm::normalize(glm::dvec3(0.3, 0.5, 0.8));
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0.0, 1.0, 0.0), view));
  const glm::dvec3 up = glm::cross(view, right);
  for (const glm::dvec3& unit : {glm::dvec3(0.0, 0.1, 1.0), glm::dvec3(0.6, 0.6, 0.5),
                                 glm::dvec3(-0.7, 0.4, 0.8), glm::dvec3(0.2, -0.4, 0.9)}) {
    const glm::dvec3 p = kHalfAxes * glm::normalize(unit);
    const double step = 1e-5;
    double largest = 0.0;
    glm::dvec3 largest_way(0.0);
    for (int i = 0; i < 7200; ++i) {
      const double angle = i * std::numbers::pi / 7200.0;
      const glm::dvec3 way = std::cos(angle) * right + std::sin(angle) * up;
      const glm::dvec3 turn = ellipsoid_normal(seen_near(p + step * way, view)) -
                              ellipsoid_normal(seen_near(p - step * way, view));
      if (glm::length(turn) / (2.0 * step) > largest) {
        largest = glm::length(turn) / (2.0 * step);
        largest_way = way;
      }
    }
    const ApparentCurvature found = apparent_curvature(ellipsoid_curvature(p), ellipsoid_normal(p), view);
    EXPECT_NEAR(found.size, largest, 1e-4 * largest);
    const glm::dvec3 shown = found.direction - view * glm::dot(found.direction, view);
    EXPECT_NEAR(glm::length(shown), 1.0, 1e-9);
    EXPECT_NEAR(std::abs(glm::dot(shown, largest_way)), 1.0, 1e-5);
    EXPECT_NEAR(glm::dot(found.direction, ellipsoid_normal(p)), 0.0, 1e-9);
  }
}

TEST(ApparentCurvature, seen_straight_on_is_the_larger_curvature) {
  const glm::dvec3 p(0.0, 0.0, kHalfAxes.z);
  const ApparentCurvature found = apparent_curvature(ellipsoid_curvature(p), {0, 0, 1}, {0, 0, 1});
  EXPECT_NEAR(found.size, kHalfAxes.z / (kHalfAxes.y * kHalfAxes.y), 1e-12);
  EXPECT_NEAR(std::abs(found.direction.y), 1.0, 1e-12);
}

// ---- A sheet with a wave along x, the same at every y: z = 0.5 exp(-x^2).

double wave_slope(double x) {
  return -x * std::exp(-x * x);
}

/// Of the sheet seen from far away, `angle` to the right of straight above.
double wave_apparent(double x, double angle) {
  const double second = (2.0 * x * x - 1.0) * std::exp(-x * x);
  const double slope = wave_slope(x), length = std::sqrt(1.0 + slope * slope);
  const double cosine = (-slope * std::sin(angle) + std::cos(angle)) / length;
  return cosine > 0.1 ? std::abs(second) / (length * length * length) / cosine : 0.0;
}

std::vector<double> wave_maxima(double angle, double limit) {
  std::vector<double> maxima;
  const double step = 1e-4;
  for (double x = -2.6; x < 2.6; x += step) {
    const double here = wave_apparent(x, angle);
    if (here >= limit && here > wave_apparent(x - step, angle) && here > wave_apparent(x + step, angle))
      maxima.push_back(x);
  }
  return maxima;
}

Mesh wave_sheet(int columns, int rows) {
  Mesh mesh;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      // Shifted from row to row, so that no line runs along the mesh's edges.
      const double x = -3.0 + 6.0 * (i + (j % 2) * 0.5) / columns;
      mesh.positions.emplace_back(x, 4.0 * j / rows, 0.5 * std::exp(-x * x));
    }
  }
  const auto at = [&](int i, int j) { return static_cast<uint32_t>(j * (columns + 1) + i); };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      mesh.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

TEST(ApparentRidges, of_a_wave_run_where_its_apparent_curvature_is_largest) {
  const SmoothSurface surface = smooth_surface_of(wave_sheet(240, 120));
  const double limit = 0.3;
  for (const double angle : {0.0, 0.5, 1.0}) {
    const std::vector<SurfaceLine> lines =
        apparent_ridges(surface, Viewpoint::at_infinity({std::sin(angle), 0.0, std::cos(angle)}),
                        {.limit = limit, .weak_share = 1.0, .shortest = 1.0});
    const std::vector<double> maxima = wave_maxima(angle, limit);
    ASSERT_FALSE(maxima.empty());
    EXPECT_EQ(lines.size(), maxima.size()) << angle;
    for (const SurfaceLine& line : lines) {
      double low = 4.0, high = 0.0, farthest = 0.0;
      const auto nearest = std::ranges::min_element(
          maxima, {}, [&](double x) { return std::abs(x - line.points[line.points.size() / 2].x); });
      for (const glm::dvec3& point : line.points) {
        if (point.y < 0.2 || point.y > 3.8) continue;  // at the sheet's border the curvature is not known
        farthest = std::max(farthest, std::abs(point.x - *nearest));
        low = std::min(low, point.y);
        high = std::max(high, point.y);
      }
      EXPECT_LT(farthest, 0.03) << angle;
      EXPECT_GT(high - low, 3.4) << angle;
    }
  }
}

TEST(ApparentRidges, a_ball_has_none_but_its_outline) {
  EXPECT_TRUE(
      apparent_ridges(smooth_surface_of(make_sphere(64)), {2.0, 1.0, 3.0}, {.limit = 1.2, .shortest = 0.3})
          .empty());
}

TEST(ApparentRidges, are_on_the_side_that_faces_the_eye) {
  const SmoothSurface surface = smooth_surface_of(wave_sheet(60, 30));
  const ApparentRidgeParams params{.limit = 0.3, .weak_share = 1.0, .shortest = 1.0};
  EXPECT_FALSE(apparent_ridges(surface, Viewpoint::at_infinity({0.2, 0.0, 1.0}), params).empty());
  EXPECT_TRUE(apparent_ridges(surface, Viewpoint::at_infinity({0.2, 0.0, -1.0}), params).empty());
}

TEST(ApparentRidges, of_a_surface_of_another_size_are_the_same) {
  const auto find = [](double size) {
    const SmoothSurface surface = smooth_surface_of(wave_sheet(60, 30), glm::dmat3(size));
    return apparent_ridges(surface, Viewpoint(size * glm::dvec3(4.0, 1.0, 7.0)),
                           {.limit = 0.3 / size, .weak_share = 0.5, .shortest = 0.2 * size});
  };
  const std::vector<SurfaceLine> lines = find(1.0), large = find(1024.0);
  ASSERT_FALSE(lines.empty());
  ASSERT_EQ(lines.size(), large.size());
  for (size_t i = 0; i < lines.size(); ++i) EXPECT_EQ(lines[i].crossings, large[i].crossings);
}

// ---- The size of features

TEST(FeatureSize, of_a_ball_is_a_hundredth_of_its_radius) {
  EXPECT_NEAR(feature_size(smooth_surface_of(make_rounded_box(32, 0.5F))), 0.005, 0.0005);
}

TEST(FeatureSize, is_at_most_a_twentieth_of_the_bounding_radius) {
  EXPECT_NEAR(feature_size(smooth_surface_of(make_box(6))), 0.05 * std::sqrt(3.0) / 2.0, 1e-6);
}

TEST(FeatureSize, follows_the_gentlest_tenth_of_all_curvatures) {
  // Half of a torus's curvatures are its tube's. A fifth of the others belong to points of the tube within 18
  // degrees of its top or bottom: up to cos(72 deg) / (1 +- 0.4 cos(72 deg)) = 0.275 to 0.353.
  EXPECT_NEAR(feature_size(smooth_surface_of(make_torus(128, 0.4F))), 0.01 / 0.3, 0.003);
}

TEST(FeatureSize, grows_with_the_surface) {
  const SmoothSurface one = smooth_surface_of(make_torus(64, 0.4F));
  const SmoothSurface large = smooth_surface_of(make_torus(64, 0.4F), glm::dmat3(1000.0));
  EXPECT_NEAR(feature_size(large), 1000.0 * feature_size(one), 1e-6 * feature_size(large));
}

}  // namespace
}  // namespace inkbench
