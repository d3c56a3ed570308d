// SPDX-License-Identifier: MIT
// Polylines as cubic Bezier paths: how far they are apart, how few pieces, corners.
#include "pipeline/vectors/fit_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace inkbench {
namespace {

using Points = std::vector<glm::dvec2>;

Points circle_points(double radius, int count) {
  Points points;
  for (int i = 0; i <= count; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i % count) / count;
    points.emplace_back(100.0 + radius * std::cos(angle), 80.0 + radius * std::sin(angle));
  }
  return points;
}

/// Bends of all sizes, a spike, a long straight part, unevenly spaced.
Points scribble(unsigned seed) {
  Points points;
  glm::dvec2 at(0.0);
  double heading = 0.3 * seed;
  uint32_t state = seed * 2654435761U + 1U;
  const auto random = [&] { return ((state = state * 1664525U + 1013904223U) >> 8) / 16777216.0; };
  for (int i = 0; i < 300; ++i) {
    points.push_back(at);
    heading += i % 70 == 69 ? 2.5 : (random() - 0.5) * 0.4 + 0.2 * std::sin(0.07 * i);
    at += (i % 100 == 50 ? 60.0 : 0.2 + 2.5 * random()) * glm::dvec2(std::cos(heading), std::sin(heading));
  }
  return points;
}

Points dense_path(const CubicPath& path) {
  Points points{path.start};
  for (size_t i = 0; i < path.pieces.size(); ++i) {
    for (int step = 1; step <= 60; ++step) points.push_back(path.cubic(i).at(step / 60.0));
  }
  return points;
}

double distance_to(const Points& line, const glm::dvec2& at) {
  double nearest = 1e300;
  for (size_t i = 1; i < line.size(); ++i) {
    const glm::dvec2 step = line[i] - line[i - 1];
    const double share = std::clamp(glm::dot(at - line[i - 1], step) / glm::dot(step, step), 0.0, 1.0);
    nearest = std::min(nearest, glm::distance(at, line[i - 1] + share * step));
  }
  return nearest;
}

double farthest(const Points& of, const Points& from) {
  double most = 0.0;
  for (const glm::dvec2& point : of) most = std::max(most, distance_to(from, point));
  return most;
}

size_t curves_in(const CubicPath& path) {
  return static_cast<size_t>(std::count_if(path.pieces.begin(), path.pieces.end(),
                                           [](const PathPiece& piece) { return !piece.is_line; }));
}

TEST(FitPath, path_and_polyline_are_nowhere_farther_apart_than_asked) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const double error = seed % 3 == 0 ? 0.5 : seed % 3 == 1 ? 0.05 : 0.1;
    const Points points = scribble(seed);
    const CubicPath path = fit_path(points, {.error = error});
    const Points drawn = dense_path(path);
    EXPECT_LE(farthest(drawn, points), error) << seed;
    EXPECT_LE(farthest(points, drawn), error + 1e-3) << seed;
  }
}

TEST(FitPath, larger_error_takes_fewer_pieces) {
  const Points points = scribble(5);
  EXPECT_LT(2 * fit_path(points, {.error = 0.5}).pieces.size(),
            fit_path(points, {.error = 0.02}).pieces.size());
}

TEST(FitPath, circle_is_a_few_curves) {
  for (const double radius : {1.5, 10.0, 60.0}) {
    const CubicPath path = fit_path(circle_points(radius, 400), {.error = 0.05});
    EXPECT_TRUE(path.is_closed);
    EXPECT_LE(path.pieces.size(), 5U) << radius;
    EXPECT_EQ(path.pieces.back().end, path.start);
  }
}

TEST(FitPath, closed_path_is_smooth_where_it_begins) {
  const CubicPath path = fit_path(circle_points(30.0, 300), {.error = 0.05});
  const glm::dvec2 out = glm::normalize(path.cubic(0).first_derivative(0.0));
  const glm::dvec2 in = glm::normalize(path.cubic(path.pieces.size() - 1).first_derivative(1.0));
  EXPECT_GT(glm::dot(in, out), 0.99999);
}

TEST(FitPath, square_is_four_lines_between_its_corners) {
  const Points square{{5, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}, {5, 0}};
  const CubicPath path = fit_path(square, {.error = 0.5});
  EXPECT_TRUE(path.is_closed);
  ASSERT_EQ(path.pieces.size(), 4U);
  EXPECT_EQ(curves_in(path), 0U);
  EXPECT_EQ(path.start, glm::dvec2(10, 0));
  EXPECT_EQ(path.pieces[0].end, glm::dvec2(10, 10));
  EXPECT_EQ(path.pieces[1].end, glm::dvec2(0, 10));
  EXPECT_EQ(path.pieces[2].end, glm::dvec2(0, 0));
}

TEST(FitPath, path_runs_through_a_corner_between_curves) {
  Points points;
  for (int i = 0; i <= 60; ++i) points.emplace_back(i, 0.004 * i * i);
  const glm::dvec2 corner = points.back();
  for (int i = 1; i <= 60; ++i) points.emplace_back(60 - i, corner.y + 0.006 * i * i);
  const CubicPath path = fit_path(points, {.error = 0.3});
  EXPECT_LE(path.pieces.size(), 4U);
  EXPECT_TRUE(std::any_of(path.pieces.begin(), path.pieces.end(),
                          [&](const PathPiece& piece) { return piece.end == corner; }));
}

TEST(FitPath, straight_points_are_one_line) {
  const CubicPath path = fit_path(Points{{1, 1}, {2, 1}, {2, 1}, {7, 1}, {900, 1}}, {});
  ASSERT_EQ(path.pieces.size(), 1U);
  EXPECT_TRUE(path.pieces[0].is_line);
}

TEST(FitPath, one_point_or_none_has_no_pieces) {
  EXPECT_TRUE(fit_path(Points{}, {}).pieces.empty());
  EXPECT_TRUE(fit_path(Points{{3, 4}, {3, 4}}, {}).pieces.empty());
}

TEST(FitPath, way_and_back_on_itself_stays_both) {
  const CubicPath path = fit_path(Points{{0, 0}, {50, 0}, {0, 0}}, {});
  ASSERT_EQ(path.pieces.size(), 2U);
  EXPECT_EQ(path.pieces[0].end, glm::dvec2(50, 0));
}

}  // namespace
}  // namespace inkbench
