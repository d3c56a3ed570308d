// SPDX-License-Identifier: MIT
#include "pipeline/vectors/plot_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <map>
#include <utility>

#include "pipeline/lines/chain.h"

namespace inkbench {
namespace {

/// The shares of a step between which it lies in the rectangle; the second below the first: nowhere.
std::array<double, 2> inside_shares(const glm::dvec2& from, const glm::dvec2& to, const glm::dvec2& size) {
  double begin = 0.0, end = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double step = to[axis] - from[axis];
    if (step == 0.0) {
      if (from[axis] < 0.0 || from[axis] > size[axis]) return {1.0, 0.0};
      continue;
    }
    const double low = -from[axis] / step, high = (size[axis] - from[axis]) / step;
    begin = std::max(begin, std::min(low, high));
    end = std::min(end, std::max(low, high));
  }
  return {begin, end};
}

void cut_line(const PlotLine& line, const glm::dvec2& size, std::vector<PlotLine>& pieces) {
  bool goes_on = false;
  for (size_t i = 1; i < line.size(); ++i) {
    const auto [begin, end] = inside_shares(line[i - 1], line[i], size);
    if (begin >= end) {
      goes_on = false;
      continue;
    }
    if (!goes_on || begin > 0.0) pieces.push_back({glm::mix(line[i - 1], line[i], begin)});
    pieces.back().push_back(end < 1.0 ? glm::mix(line[i - 1], line[i], end) : line[i]);
    goes_on = end == 1.0;
  }
}

/// Gives ends that lie near each other one number.
class EndNumbers {
 public:
  EndNumbers(double nearness, std::vector<glm::dvec3>& points) : nearness_(nearness), points_(points) {}

  uint32_t number(const glm::dvec2& at) {
    const auto cell = [&](double value) { return static_cast<int64_t>(std::floor(value / nearness_)); };
    const Cell here{cell(at.x), cell(at.y)};
    for (int64_t x = here.first - 1; x <= here.first + 1; ++x) {
      for (int64_t y = here.second - 1; y <= here.second + 1; ++y) {
        for (const uint32_t point : cells_[{x, y}]) {
          if (std::hypot(points_[point].x - at.x, points_[point].y - at.y) <= nearness_) return point;
        }
      }
    }
    points_.emplace_back(at.x, at.y, 0.0);
    cells_[here].push_back(static_cast<uint32_t>(points_.size() - 1));
    return cells_[here].back();
  }

 private:
  using Cell = std::pair<int64_t, int64_t>;
  double nearness_;
  std::vector<glm::dvec3>& points_;
  std::map<Cell, std::vector<uint32_t>> cells_;
};

}  // namespace

bool is_closed(const PlotLine& line) {
  return line.size() > 2 && line.front() == line.back();
}

std::vector<PlotLine> cut_to_sheet(const std::vector<PlotLine>& lines, const glm::dvec2& size) {
  std::vector<PlotLine> pieces;
  for (const PlotLine& line : lines) cut_line(line, size, pieces);
  return pieces;
}

std::vector<PlotLine> join_ends(const std::vector<PlotLine>& lines, double nearness) {
  std::vector<glm::dvec3> points;
  std::vector<Link> links;
  EndNumbers ends(nearness, points);
  for (const PlotLine& line : lines) {
    uint32_t at = ends.number(line.front());
    for (size_t i = 1; i < line.size(); ++i) {
      uint32_t next = 0;
      if (i + 1 == line.size()) {
        next = ends.number(line.back());
      } else {
        next = static_cast<uint32_t>(points.size());
        points.emplace_back(line[i].x, line[i].y, 0.0);
      }
      if (next != at) links.push_back({at, next});
      at = next;
    }
  }
  std::vector<PlotLine> joined;
  for (const Chain& chain : chain_links(points, links, 180.0)) {
    PlotLine& line = joined.emplace_back();
    for (const uint32_t point : chain) line.emplace_back(points[point].x, points[point].y);
  }
  return joined;
}

}  // namespace inkbench
