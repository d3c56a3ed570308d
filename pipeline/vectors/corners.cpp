// SPDX-License-Identifier: MIT
#include "pipeline/vectors/corners.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace inkbench {

Course::Course(std::span<const glm::dvec2> points, bool is_closed) : points_(points), is_closed_(is_closed) {
  along_.reserve(points.size());
  along_.push_back(0.0);
  for (size_t i = 1; i < points.size(); ++i)
    along_.push_back(along_.back() + glm::distance(points[i], points[i - 1]));
}

glm::dvec2 Course::place(size_t from, double length) const {
  double along = along_[from] + length;
  if (is_closed_) along -= std::floor(along / this->length()) * this->length();
  along = std::clamp(along, 0.0, this->length());
  const auto above = std::upper_bound(along_.begin() + 1, along_.end() - 1, along);
  const size_t after = static_cast<size_t>(above - along_.begin());
  const double share = (along - along_[after - 1]) / (along_[after] - along_[after - 1]);
  return glm::mix(points_[after - 1], points_[after], share);
}

glm::dvec2 Course::direction(size_t point, double reach) const {
  const glm::dvec2 across = place(point, reach) - place(point, -reach);
  return glm::normalize(across == glm::dvec2(0.0) ? place(point, reach) - points_[point] : across);
}

double Course::turn_deg(size_t point, double reach) const {
  const glm::dvec2 in = points_[point] - place(point, -reach), out = place(point, reach) - points_[point];
  const double turn = std::atan2(std::abs(in.x * out.y - in.y * out.x), glm::dot(in, out));
  return glm::degrees(turn);
}

std::vector<size_t> Course::corners(double corner_deg, double reach) const {
  std::vector<std::pair<size_t, double>> found;  // with the turn
  for (size_t i = is_closed_ ? 0 : 1; i + 1 < points_.size(); ++i) {
    const double turn = turn_deg(i, reach);
    if (turn <= corner_deg) continue;
    if (!found.empty() && along_[i] - along_[found.back().first] < reach) {
      if (turn > found.back().second) found.back() = {i, turn};
    } else {
      found.emplace_back(i, turn);
    }
  }
  if (is_closed_ && found.size() > 1 &&
      length() - along_[found.back().first] + along_[found[0].first] < reach)
    found.erase(found[0].second < found.back().second ? found.begin() : found.end() - 1);
  std::vector<size_t> corners;
  for (const auto& [point, turn] : found) corners.push_back(point);
  return corners;
}

void begin_at(size_t point, std::vector<glm::dvec2>& closed) {
  closed.pop_back();
  std::rotate(closed.begin(), closed.begin() + static_cast<std::ptrdiff_t>(point), closed.end());
  closed.push_back(closed.front());
}

}  // namespace inkbench
