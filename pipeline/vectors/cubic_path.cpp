// SPDX-License-Identifier: MIT
#include "pipeline/vectors/cubic_path.h"

namespace inkbench {

glm::dvec2 Cubic::at(double u) const {
  const double v = 1.0 - u;
  return v * v * v * start + 3.0 * v * v * u * leave + 3.0 * v * u * u * enter + u * u * u * end;
}

glm::dvec2 Cubic::first_derivative(double u) const {
  const double v = 1.0 - u;
  return 3.0 * (v * v * (leave - start) + 2.0 * v * u * (enter - leave) + u * u * (end - enter));
}

glm::dvec2 Cubic::second_derivative(double u) const {
  return 6.0 * ((1.0 - u) * (enter - 2.0 * leave + start) + u * (end - 2.0 * enter + leave));
}

Cubic CubicPath::cubic(size_t piece) const {
  const glm::dvec2 from = piece == 0 ? start : pieces[piece - 1].end;
  const PathPiece& to = pieces[piece];
  if (!to.is_line) return {from, to.leave, to.enter, to.end};
  return {from, from + (to.end - from) / 3.0, to.end - (to.end - from) / 3.0, to.end};
}

}  // namespace inkbench
