// SPDX-License-Identifier: MIT
// Smooth paths: cubic Bezier curves and straight lines end to end, as vector files hold them.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace inkbench {

/// A cubic Bezier curve: `start` and `end`, and the controls that it leaves and enters along.
struct Cubic {
  glm::dvec2 start{0.0}, leave{0.0}, enter{0.0}, end{0.0};

  /// At the parameter `u`, 0 to 1.
  glm::dvec2 at(double u) const;
  glm::dvec2 first_derivative(double u) const;
  glm::dvec2 second_derivative(double u) const;
};

/// What goes on from where the path is to `end`; a line has no controls.
struct PathPiece {
  glm::dvec2 leave{0.0}, enter{0.0}, end{0.0};
  bool is_line = false;
};

struct CubicPath {
  glm::dvec2 start{0.0};
  std::vector<PathPiece> pieces;  ///< Of a closed path the last one ends at `start`.
  bool is_closed = false;

  /// A line as the cubic along it.
  Cubic cubic(size_t piece) const;
};

}  // namespace inkbench
