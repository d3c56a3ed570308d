// SPDX-License-Identifier: MIT
#include "pipeline/vectors/fit_cubic.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <vector>

namespace inkbench {
namespace {

constexpr int kMostRounds = 12;  ///< Of moving the parameters.
constexpr double kHopeless =
    30.0;  ///< Times the error: where the first curve is that far off, no round helps.
constexpr double kShortest = 1e-3;  ///< Of a control's distance, of the chord.
constexpr double kLongest = 3.0;    ///< The same: longer ones make loops.

using Parameters = std::vector<double>;

Parameters chord_lengths(std::span<const glm::dvec2> points) {
  Parameters at(points.size(), 0.0);
  for (size_t i = 1; i < points.size(); ++i) at[i] = at[i - 1] + glm::distance(points[i], points[i - 1]);
  const double whole = at.back();
  for (double& u : at) u /= whole;
  at.back() = 1.0;
  return at;
}

/// The controls' distances from the ends by which the curve is nearest to the points, in least squares.
Cubic least_squares(std::span<const glm::dvec2> points, const Parameters& at, const glm::dvec2& leaving,
                    const glm::dvec2& arriving) {
  const glm::dvec2 first = points.front(), last = points.back();
  double aa = 0.0, ab = 0.0, bb = 0.0, ax = 0.0, bx = 0.0;
  for (size_t i = 0; i < points.size(); ++i) {
    const double u = at[i], v = 1.0 - u;
    const double near_first = v * v * (v + 3.0 * u), near_last = u * u * (u + 3.0 * v);
    const glm::dvec2 a = leaving * (3.0 * v * v * u), b = arriving * (3.0 * v * u * u);
    const glm::dvec2 rest = points[i] - near_first * first - near_last * last;
    aa += glm::dot(a, a);
    ab += glm::dot(a, b);
    bb += glm::dot(b, b);
    ax += glm::dot(a, rest);
    bx += glm::dot(b, rest);
  }
  const double chord = glm::distance(first, last);
  const double determinant = aa * bb - ab * ab;
  double leave = -1.0, enter = -1.0;
  if (determinant > 1e-12 * aa * bb) {
    leave = (ax * bb - bx * ab) / determinant;
    enter = (bx * aa - ax * ab) / determinant;
  }
  const auto is_fit = [&](double length) { return length > kShortest * chord && length < kLongest * chord; };
  if (!is_fit(leave) || !is_fit(enter)) leave = enter = chord / 3.0;
  return {first, first + leave * leaving, last + enter * arriving, last};
}

/// How far curve and polyline are apart at most, walked along as the parameters say. On each step of the
/// polyline the difference is a cubic in u, which leaves the straight line between its ends by no more than
/// its second derivative allows.
double most_apart(std::span<const glm::dvec2> points, const Parameters& at, const Cubic& cubic) {
  double most = 0.0, before = 0.0;
  for (size_t i = 1; i < points.size(); ++i) {
    const double here = glm::distance(cubic.at(at[i]), points[i]);
    const double step = at[i] - at[i - 1];
    const double bend = std::max(glm::length(cubic.second_derivative(at[i - 1])),
                                 glm::length(cubic.second_derivative(at[i])));
    most = std::max(most, std::max(before, here) + bend * step * step / 8.0);
    before = here;
  }
  return most;
}

/// One step of Newton's method towards where the curve is nearest to each point. Returns whether the
/// parameters still grow.
bool move_to_nearest(std::span<const glm::dvec2> points, const Cubic& cubic, Parameters& at) {
  for (size_t i = 1; i + 1 < points.size(); ++i) {
    const glm::dvec2 apart = cubic.at(at[i]) - points[i];
    const glm::dvec2 first = cubic.first_derivative(at[i]);
    const double slope = glm::dot(first, first) + glm::dot(apart, cubic.second_derivative(at[i]));
    if (slope > 0.0) at[i] = std::clamp(at[i] - glm::dot(apart, first) / slope, 0.0, 1.0);
    if (at[i] < at[i - 1]) return false;
  }
  return true;
}

}  // namespace

std::optional<Cubic> fit_cubic(std::span<const glm::dvec2> points, const glm::dvec2& leaving,
                               const glm::dvec2& arriving, double error) {
  if (points.front() == points.back()) return std::nullopt;
  Parameters at = chord_lengths(points);
  for (int round = 0; round < kMostRounds; ++round) {
    const Cubic cubic = least_squares(points, at, leaving, arriving);
    const double apart = most_apart(points, at, cubic);
    if (apart <= error) return cubic;
    if (apart > kHopeless * error || !move_to_nearest(points, cubic, at)) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace inkbench
