// SPDX-License-Identifier: MIT
#include "pipeline/vectors/smooth_border.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <map>
#include <utility>

#include "pipeline/base/stop.h"
#include "pipeline/vectors/corners.h"
#include "pipeline/vectors/fit_path.h"

namespace inkbench {
namespace {

constexpr double kSigma = 2.6;         ///< px, along the border.
constexpr double kCornerReach = 7.0;   ///< px: staircases of any slope turn by less within it ...
constexpr double kCornerDeg = 50.0;    ///< ... than this.
constexpr double kTangentReach = 2.0;  ///< px.

using Points = std::vector<glm::dvec2>;

/// The mean of a line's places round one, weighed by their distance along the line, as far as `reach` to both
/// sides; near enough to `here`.
glm::dvec2 evened_place(const Course& course, size_t point, const glm::dvec2& here, double reach) {
  glm::dvec2 sum = here;
  double weights = 1.0;
  for (double away = 0.5; away <= reach; away += 0.5) {
    const double weight = std::exp(-0.5 * (away / kSigma) * (away / kSigma));
    sum += weight * (course.place(point, away) + course.place(point, -away));
    weights += 2.0 * weight;
  }
  const glm::dvec2 moved = sum / weights - here;
  return here + moved * std::min(1.0, kMostMoved / std::max(glm::length(moved), 1e-9));
}

constexpr double kReach = 3.0 * kSigma;

/// Never evened farther one way than the other, so that ends stay and straight parts keep their direction.
Points evened(const Points& points, bool is_round) {
  const Course course(points, is_round);
  Points result = points;
  for (size_t i = 0; i < points.size(); ++i) {
    const double to_end = std::min(course.between(0, i), course.between(i, points.size() - 1));
    result[i] = evened_place(course, i, points[i], is_round ? kReach : std::min(kReach, to_end));
  }
  if (is_round) result.back() = result.front();
  return result;
}

/// The middles of the pixels' sides along a part of a border.
Points middles(const Points& corners, size_t first, size_t last) {
  Points points;
  for (size_t i = first; i < last; ++i) points.push_back(0.5 * (corners[i] + corners[i + 1]));
  return points;
}

using BorderEnd = std::pair<size_t, bool>;  ///< A border's number; whether it is its last corner.

/// Where the borders' ends lie that meet in one corner of pixels.
class MeetingPlace {
 public:
  MeetingPlace(const BorderNetwork& network, const std::vector<BorderEnd>& ends) {
    for (const auto& [border, is_last] : ends) ways_.push_back(way(network.borders[border], is_last));
  }

  glm::dvec2 place() const {
    double least_turn = kCornerDeg;
    glm::dvec2 best = ways_[0][0];
    for (size_t i = 0; i < ways_.size(); ++i) {
      for (size_t j = i + 1; j < ways_.size(); ++j) {
        const double turn = turn_deg(ways_[i], ways_[j]);
        if (turn >= least_turn) continue;
        least_turn = turn;
        best = evened_through(ways_[i], ways_[j]);
      }
    }
    return best;
  }

 private:
  /// From the end some corners into the border.
  static Points way(const Border& border, bool is_last) {
    Points corners(border.corners.begin(), border.corners.end());
    if (is_last) std::reverse(corners.begin(), corners.end());
    corners.resize(std::min(corners.size(), static_cast<size_t>(kReach) + 2));
    return corners;
  }

  static double turn_deg(const Points& one, const Points& other) {
    const auto far = [](const Points& way) {
      return way[std::min(way.size() - 1, static_cast<size_t>(kCornerReach))] - way[0];
    };
    const glm::dvec2 in = -far(one), out = far(other);
    return glm::degrees(std::atan2(std::abs(in.x * out.y - in.y * out.x), glm::dot(in, out)));
  }

  static glm::dvec2 evened_through(const Points& one, const Points& other) {
    Points points = middles(one, 0, one.size() - 1);
    std::reverse(points.begin(), points.end());
    const size_t middle = points.size();
    const Points after = middles(other, 0, other.size() - 1);
    points.push_back(0.5 * (points.back() + after.front()));
    points.insert(points.end(), after.begin(), after.end());
    const Course course(points, false);
    const double to_end = std::min(course.between(0, middle), course.between(middle, points.size() - 1));
    return evened_place(course, middle, points[middle], std::min(kReach, to_end));
  }

  std::vector<Points> ways_;
};

/// For each border where its first and its last corner come to lie.
std::vector<std::array<glm::dvec2, 2>> meeting_places(const BorderNetwork& network) {
  std::map<std::pair<int, int>, std::vector<BorderEnd>> meetings;
  for (size_t i = 0; i < network.borders.size(); ++i) {
    const auto& corners = network.borders[i].corners;
    if (network.borders[i].is_round) continue;
    meetings[{corners.front().x, corners.front().y}].emplace_back(i, false);
    meetings[{corners.back().x, corners.back().y}].emplace_back(i, true);
  }
  std::vector<std::array<glm::dvec2, 2>> places(network.borders.size());
  for (const auto& [corner, ends] : meetings) {
    glm::dvec2 place = MeetingPlace(network, ends).place();
    if (corner.first == 0 || corner.first == network.size.x) place.x = corner.first;
    if (corner.second == 0 || corner.second == network.size.y) place.y = corner.second;
    for (const auto& [border, is_last] : ends) places[border][is_last ? 1 : 0] = place;
  }
  return places;
}

FitOptions border_fit(double error_px) {
  return {.error = error_px, .corner_deg = 180.0, .line_share = 1.0, .corner_reach = kTangentReach};
}

/// A border that goes round without a corner.
CubicPath round_path(const Points& corners, double error_px) {
  Points points = middles(corners, 0, corners.size() - 1);
  points.push_back(points.front());
  return fit_path(evened(points, true), border_fit(error_px));
}

/// From one place by the parts between its corners to another.
CubicPath path_through(const Points& corners, const std::vector<size_t>& ends, const glm::dvec2& first,
                       const glm::dvec2& last, double error_px) {
  CubicPath path{first, {}, first == last};
  for (size_t i = 1; i < ends.size(); ++i) {
    Points points = middles(corners, ends[i - 1], ends[i]);
    points.insert(points.begin(), i == 1 ? first : corners[ends[i - 1]]);
    points.push_back(i + 1 == ends.size() ? last : corners[ends[i]]);
    const CubicPath part = fit_path(evened(points, false), border_fit(error_px));
    path.pieces.insert(path.pieces.end(), part.pieces.begin(), part.pieces.end());
  }
  return path;
}

/// Where the border turns sharply. Near its ends a staircase may look so: there only the image's corners
/// count.
std::vector<size_t> sharp_corners(const Points& corners, bool is_round, const glm::ivec2& size) {
  const Course course(corners, is_round);
  std::vector<size_t> sharp = course.corners(kCornerDeg, kCornerReach);
  const auto is_uncertain = [&](size_t corner) {
    const glm::dvec2 at = corners[corner];
    const bool is_of_image = (at.x == 0.0 || at.x == size.x) && (at.y == 0.0 || at.y == size.y);
    const double to_end = std::min(course.between(0, corner), course.between(corner, corners.size() - 1));
    return !is_round && !is_of_image && to_end < kCornerReach / 2.0;
  };
  sharp.erase(std::remove_if(sharp.begin(), sharp.end(), is_uncertain), sharp.end());
  return sharp;
}

CubicPath smooth_border(const Border& border, const std::array<glm::dvec2, 2>& places, const glm::ivec2& size,
                        double error_px) {
  Points corners(border.corners.begin(), border.corners.end());
  std::vector<size_t> ends = sharp_corners(corners, border.is_round, size);
  if (border.is_round && ends.empty()) return round_path(corners, error_px);
  if (border.is_round) {
    const size_t first = ends.front();
    begin_at(first, corners);
    for (size_t& end : ends) end -= first;
  } else {
    ends.insert(ends.begin(), 0);
  }
  ends.push_back(corners.size() - 1);
  const bool keeps_ends = border.is_round;
  return path_through(corners, ends, keeps_ends ? corners.front() : places[0],
                      keeps_ends ? corners.back() : places[1], error_px);
}

}  // namespace

std::vector<CubicPath> smooth_borders(const BorderNetwork& network, double error_px) {
  const auto places = meeting_places(network);
  std::vector<CubicPath> paths;
  for (size_t i = 0; i < network.borders.size(); ++i) {
    stop_if_asked();
    paths.push_back(smooth_border(network.borders[i], places[i], network.size, error_px));
  }
  return paths;
}

}  // namespace inkbench
