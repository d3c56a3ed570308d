// SPDX-License-Identifier: MIT
#include "pipeline/vectors/fit_cubic.h"

#include <algorithm>
#include <array>
#include <cmath>
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

/// Which way a control may move from its end of the curve.
struct Freedom {
  bool of_leave = false;
  glm::dvec2 way{0.0};
};

std::vector<Freedom> freedoms(const std::optional<glm::dvec2>& leaving,
                              const std::optional<glm::dvec2>& arriving) {
  std::vector<Freedom> result;
  for (const bool of_leave : {true, false}) {
    const auto& way = of_leave ? leaving : arriving;
    if (way) {
      result.push_back({of_leave, *way});
    } else {
      result.push_back({of_leave, {1.0, 0.0}});
      result.push_back({of_leave, {0.0, 1.0}});
    }
  }
  return result;
}

constexpr size_t kMostFreedoms = 4;
struct Equations {
  size_t count = 0;
  std::array<std::array<double, kMostFreedoms>, kMostFreedoms> matrix{};
  std::array<double, kMostFreedoms> right{};
};

/// By Cholesky's method. Nothing where the equations do not say what each is.
std::optional<std::array<double, kMostFreedoms>> solve(Equations of) {
  for (size_t column = 0; column < of.count; ++column) {
    auto& pivot_row = of.matrix[column];
    const double own = pivot_row[column];
    for (size_t before = 0; before < column; ++before)
      pivot_row[column] -= pivot_row[before] * pivot_row[before];
    if (!(pivot_row[column] > 1e-12 * own)) return std::nullopt;
    pivot_row[column] = std::sqrt(pivot_row[column]);
    for (size_t row = column + 1; row < of.count; ++row) {
      for (size_t before = 0; before < column; ++before)
        of.matrix[row][column] -= of.matrix[row][before] * pivot_row[before];
      of.matrix[row][column] /= pivot_row[column];
    }
  }
  std::array<double, kMostFreedoms> result{};
  for (size_t i = 0; i < of.count; ++i) {
    result[i] = of.right[i];
    for (size_t before = 0; before < i; ++before) result[i] -= of.matrix[i][before] * result[before];
    result[i] /= of.matrix[i][i];
  }
  for (size_t i = of.count; i-- > 0;) {
    for (size_t after = i + 1; after < of.count; ++after) result[i] -= of.matrix[after][i] * result[after];
    result[i] /= of.matrix[i][i];
  }
  return result;
}

Equations normal_equations(std::span<const glm::dvec2> points, const Parameters& at,
                           const std::vector<Freedom>& free) {
  Equations equations{free.size(), {}, {}};
  std::array<glm::dvec2, kMostFreedoms> moves{};
  for (size_t i = 0; i < points.size(); ++i) {
    const double u = at[i], v = 1.0 - u;
    for (size_t k = 0; k < free.size(); ++k)
      moves[k] = free[k].way * (free[k].of_leave ? 3.0 * v * v * u : 3.0 * v * u * u);
    const glm::dvec2 rest =
        points[i] - v * v * (v + 3.0 * u) * points.front() - u * u * (u + 3.0 * v) * points.back();
    for (size_t k = 0; k < free.size(); ++k) {
      equations.right[k] += glm::dot(moves[k], rest);
      for (size_t l = 0; l <= k; ++l) equations.matrix[k][l] += glm::dot(moves[k], moves[l]);
    }
  }
  return equations;
}

/// Whether a control is neither at its end nor so far away that the curve makes a loop, nor behind its end.
bool is_fit(const glm::dvec2& control, const std::optional<glm::dvec2>& way, double chord) {
  const double length = way ? glm::dot(control, *way) : glm::length(control);
  return length > kShortest * chord && length < kLongest * chord;
}

/// With the controls by which the curve is nearest to the points, in least squares; a third of the chord away
/// where that is nowhere sensible.
Cubic least_squares(std::span<const glm::dvec2> points, const Parameters& at,
                    const std::optional<glm::dvec2>& leaving, const std::optional<glm::dvec2>& arriving) {
  const glm::dvec2 first = points.front(), last = points.back();
  const double chord = glm::distance(first, last);
  const std::vector<Freedom> free = freedoms(leaving, arriving);
  if (const auto moves = solve(normal_equations(points, at, free))) {
    glm::dvec2 leave(0.0), enter(0.0);
    for (size_t k = 0; k < free.size(); ++k) (free[k].of_leave ? leave : enter) += (*moves)[k] * free[k].way;
    if (is_fit(leave, leaving, chord) && is_fit(enter, arriving, chord))
      return {first, first + leave, last + enter, last};
  }
  const glm::dvec2 along = (last - first) / chord;
  return {first, first + chord / 3.0 * leaving.value_or(along),
          last + chord / 3.0 * arriving.value_or(-along), last};
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

std::optional<Cubic> fit_cubic(std::span<const glm::dvec2> points, const std::optional<glm::dvec2>& leaving,
                               const std::optional<glm::dvec2>& arriving, double error) {
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
