// SPDX-License-Identifier: MIT
#include "pipeline/vectors/fit_path.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "pipeline/vectors/corners.h"
#include "pipeline/vectors/fit_cubic.h"

namespace inkbench {
namespace {

using Points = std::vector<glm::dvec2>;

Points without_repeated(std::span<const glm::dvec2> points) {
  Points result;
  for (const glm::dvec2& point : points) {
    if (result.empty() || point != result.back()) result.push_back(point);
  }
  return result;
}

/// Points between those that are far apart, so that what is fitted is the polyline and not its points: a
/// curve of radius r strays from a step's chord by step^2 / 8 r.
Points with_points_between(const Points& points, double error) {
  const double step = 4.0 * std::sqrt(error);
  Points result{points.front()};
  for (size_t i = 1; i < points.size(); ++i) {
    const int parts =
        std::max(1, static_cast<int>(std::ceil(glm::distance(points[i], points[i - 1]) / step)));
    for (int part = 1; part < parts; ++part)
      result.push_back(glm::mix(points[i - 1], points[i], static_cast<double>(part) / parts));
    result.push_back(points[i]);
  }
  return result;
}

/// How far the points are from the chord at most, walked along it.
double most_from_chord(std::span<const glm::dvec2> points) {
  const glm::dvec2 from = points.front(), chord = points.back() - points.front();
  const double square = glm::dot(chord, chord);
  if (square == 0.0) return std::numeric_limits<double>::infinity();
  double most = 0.0, behind = 0.0;
  for (const glm::dvec2& point : points) {
    const double share = std::clamp(glm::dot(point - from, chord) / square, behind, 1.0);
    most = std::max(most, glm::distance(point, from + share * chord));
    behind = share;
  }
  return most;
}

/// From corner to corner, one curve after the other, each as long as it can be.
class SectionFitter {
 public:
  SectionFitter(std::span<const glm::dvec2> points, const Course& course, const FitOptions& options)
      : points_(points), course_(course), options_(options) {}

  /// `is_round`: the section's ends are one smooth point.
  void fit(size_t first, size_t last, bool is_round, std::vector<PathPiece>& pieces) {
    first_ = first;
    last_ = last;
    is_round_ = is_round;
    std::vector<size_t> joints{first};
    while (joints.back() < last) {
      const auto [end, piece] = longest_from(joints.back());
      pieces.push_back(piece);
      joints.push_back(end);
    }
    if (joints.size() > 2) share_evenly(joints[joints.size() - 3], last, pieces);
  }

 private:
  /// The direction into the run that begins (`sign` 1) or ends (-1) there; none at a corner.
  std::optional<glm::dvec2> tangent(size_t point, int sign) const {
    const bool is_end = point == first_ || point == last_;
    if (is_end && !is_round_) return std::nullopt;
    const double reach = std::min(options_.corner_reach, course_.between(first_, last_) / 4.0);
    return static_cast<double>(sign) * course_.direction(point, reach);
  }

  std::optional<PathPiece> piece(size_t from, size_t to) const {
    const auto run = points_.subspan(from, to - from + 1);
    const double share =
        from == first_ && to == last_ ? options_.line_share : std::min(options_.line_share, kLineShare);
    if (most_from_chord(run) <= share * options_.error) return PathPiece{{}, {}, run.back(), true};
    const auto cubic = fit_cubic(run, tangent(from, 1), tangent(to, -1), options_.error);
    if (!cubic) return std::nullopt;
    return PathPiece{cubic->leave, cubic->enter, cubic->end, false};
  }

  /// What is left for the last piece may be short, with a bend where it begins: so it and the one before
  /// share their run in halves, where that fits.
  void share_evenly(size_t from, size_t to, std::vector<PathPiece>& pieces) const {
    const size_t middle = (from + to) / 2;
    const auto before = piece(from, middle), after = piece(middle, to);
    if (!before || !after || before->is_line || after->is_line) return;
    pieces[pieces.size() - 2] = *before;
    pieces.back() = *after;
  }

  /// Doubled until no curve fits, then the largest between.
  std::pair<size_t, PathPiece> longest_from(size_t from) const {
    size_t good = from + 1, bad = last_ + 1;
    PathPiece best{{}, {}, points_[good], true};
    const auto try_to = [&](size_t to) {
      const auto found = piece(from, to);
      if (found) {
        good = to;
        best = *found;
      } else {
        bad = to;
      }
    };
    for (size_t reach = 8; bad > last_ && good < last_; reach *= 2) try_to(std::min(from + reach, last_));
    while (good + 1 < bad) try_to((good + bad) / 2);
    return {good, best};
  }

  static constexpr double kLineShare = 0.25;  ///< Of the error, for a line that goes on in another piece.

  std::span<const glm::dvec2> points_;
  const Course& course_;
  const FitOptions& options_;
  size_t first_ = 0, last_ = 0;
  bool is_round_ = false;
};

/// Where a closed path begins and ends, and each corner between.
std::vector<size_t> section_ends(Points& points, bool is_closed, const FitOptions& options, bool& is_round) {
  std::vector<size_t> corners = Course(points, is_closed).corners(options.corner_deg, options.corner_reach);
  is_round = is_closed && corners.empty();
  if (is_closed && !corners.empty()) {
    const size_t first = corners.front();
    begin_at(first, points);
    for (size_t& corner : corners) corner -= first;
  } else {
    corners.insert(corners.begin(), 0);
  }
  corners.push_back(points.size() - 1);
  return corners;
}

CubicPath fit_different(Points points, const FitOptions& options) {
  const bool is_closed = points.size() > 3 && points.front() == points.back();
  bool is_round = false;
  const std::vector<size_t> ends = section_ends(points, is_closed, options, is_round);
  const Course course(points, is_closed);
  SectionFitter fitter(points, course, options);
  CubicPath path{points.front(), {}, is_closed};
  for (size_t i = 1; i < ends.size(); ++i) fitter.fit(ends[i - 1], ends[i], is_round, path.pieces);
  return path;
}

}  // namespace

CubicPath fit_path(std::span<const glm::dvec2> points, const FitOptions& options) {
  const Points different = without_repeated(points);
  if (different.empty()) return {};
  if (different.size() < 2) return {different.front(), {}, false};
  return fit_different(with_points_between(different, options.error), options);
}

CubicPath fit_path(std::span<const glm::vec2> points, const FitOptions& options) {
  return fit_path(Points(points.begin(), points.end()), options);
}

std::vector<CubicPath> fit_outline(const Outline& outline, const FitOptions& options) {
  std::vector<CubicPath> paths;
  for (Ring ring : outline) {
    ring.push_back(ring.front());
    CubicPath path = fit_path(ring, options);
    if (path.is_closed && path.pieces.size() > 1) paths.push_back(std::move(path));
  }
  return paths;
}

}  // namespace inkbench
