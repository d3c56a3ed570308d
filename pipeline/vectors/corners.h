// SPDX-License-Identifier: MIT
// Where a polyline turns sharply, and which way it goes elsewhere.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace inkbench {

/// A polyline with the length along it; a closed one's last point is its first one again, and it goes on
/// round.
class Course {
 public:
  /// 2 points or more, none repeated; they must outlive this.
  Course(std::span<const glm::dvec2> points, bool is_closed);

  /// From the point of that number on, along by `length` (back where it is negative), at most to the ends.
  glm::dvec2 place(size_t from, double length) const;

  /// The direction at a point: from `reach` before it to `reach` after it, a unit vector. With ends, not at
  /// them.
  glm::dvec2 direction(size_t point, double reach) const;

  /// The points at which what lies within `reach` before and after turns by more than `corner_deg`, more than
  /// at any other point that near; in order, without the ends; the first point of a closed one, too.
  std::vector<size_t> corners(double corner_deg, double reach) const;

  double between(size_t first, size_t last) const { return along_[last] - along_[first]; }
  double length() const { return along_.back(); }

 private:
  double turn_deg(size_t point, double reach) const;

  std::span<const glm::dvec2> points_;
  bool is_closed_;
  std::vector<double> along_;
};

/// Makes a closed polyline begin (and end) at another of its points.
void begin_at(size_t point, std::vector<glm::dvec2>& closed);

}  // namespace inkbench
