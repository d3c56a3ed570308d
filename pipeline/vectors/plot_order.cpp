// SPDX-License-Identifier: MIT
#include "pipeline/vectors/plot_order.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "pipeline/base/stop.h"

namespace inkbench {
namespace {

constexpr int kMostSweeps = 60;
constexpr double kWorthwhile = 1e-9;  ///< A turn that saves less is left.

/// Where the pen comes down for a line: at the point of that number, which for open ones is an end.
struct Approach {
  size_t line = 0, point = 0;
  double distance = std::numeric_limits<double>::infinity();
};

void approach(const std::vector<PlotLine>& lines, size_t line, const glm::dvec2& pen, Approach& best) {
  const PlotLine& points = lines[line];
  const size_t step = is_closed(points) ? 1 : points.size() - 1;
  for (size_t i = 0; i < points.size(); i += step) {
    const double distance = glm::distance(pen, points[i]);
    if (distance < best.distance) best = {line, i, distance};
  }
}

/// The line as it is drawn from that point on.
PlotLine drawn_from(PlotLine line, size_t point) {
  if (is_closed(line)) {
    line.pop_back();
    std::rotate(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(point % line.size()), line.end());
    line.push_back(line.front());
  } else if (point != 0) {
    std::reverse(line.begin(), line.end());
  }
  return line;
}

std::vector<PlotLine> nearest_next(std::vector<PlotLine> lines) {
  std::vector<PlotLine> ordered;
  glm::dvec2 pen(0.0);
  std::vector<size_t> left(lines.size());
  for (size_t i = 0; i < left.size(); ++i) left[i] = i;
  while (!left.empty()) {
    stop_if_asked();
    Approach best;
    for (const size_t line : left) approach(lines, line, pen, best);
    left.erase(std::find(left.begin(), left.end(), best.line));
    ordered.push_back(drawn_from(std::move(lines[best.line]), best.point));
    pen = ordered.back().back();
  }
  return ordered;
}

/// What the way gets longer by if the lines from `first` to `last` are drawn in the other direction.
double cost_of_turning(const std::vector<PlotLine>& lines, size_t first, size_t last) {
  const glm::dvec2 before = first == 0 ? glm::dvec2(0.0) : lines[first - 1].back();
  const glm::dvec2 begin = lines[first].front(), end = lines[last].back();
  double cost = glm::distance(before, end) - glm::distance(before, begin);
  if (last + 1 < lines.size()) {
    const glm::dvec2 after = lines[last + 1].front();
    cost += glm::distance(begin, after) - glm::distance(end, after);
  }
  return cost;
}

void turn(std::vector<PlotLine>& lines, size_t first, size_t last) {
  const auto begin = lines.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = lines.begin() + static_cast<std::ptrdiff_t>(last) + 1;
  std::reverse(begin, end);
  for (auto line = begin; line != end; ++line) std::reverse(line->begin(), line->end());
}

/// Whether any turn helped.
bool turn_parts(std::vector<PlotLine>& lines) {
  bool is_shorter = false;
  for (size_t first = 0; first < lines.size(); ++first) {
    stop_if_asked();
    for (size_t last = first; last < lines.size(); ++last) {
      if (cost_of_turning(lines, first, last) >= -kWorthwhile) continue;
      turn(lines, first, last);
      is_shorter = true;
    }
  }
  return is_shorter;
}

}  // namespace

double lifted_travel(const std::vector<PlotLine>& lines) {
  double travel = 0.0;
  glm::dvec2 pen(0.0);
  for (const PlotLine& line : lines) {
    travel += glm::distance(pen, line.front());
    pen = line.back();
  }
  return travel;
}

std::vector<PlotLine> in_short_order(std::vector<PlotLine> lines) {
  std::vector<PlotLine> ordered = nearest_next(lines);
  if (lifted_travel(ordered) > lifted_travel(lines)) ordered = std::move(lines);
  for (int sweep = 0; sweep < kMostSweeps && turn_parts(ordered); ++sweep) {
  }
  return ordered;
}

}  // namespace inkbench
