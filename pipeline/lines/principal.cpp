// SPDX-License-Identifier: MIT
#include "pipeline/lines/principal.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace inkbench {

glm::dvec3 perpendicular(const glm::dvec3& normal) {
  const glm::dvec3 other = std::abs(normal.x) < 0.7 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  return glm::normalize(glm::cross(normal, other));
}

Principal principal_of(const SymmetricTensor& curvature, const glm::dvec3& normal, double sign) {
  const glm::dvec3 u = perpendicular(normal);
  const glm::dvec3 v = glm::cross(normal, u);
  const double uu = sign * quadratic_form(curvature, u);
  const double vv = sign * quadratic_form(curvature, v);
  const double uv = (sign * quadratic_form(curvature, u + v) - uu - vv) / 2.0;
  const double spread = std::hypot((uu - vv) / 2.0, uv);
  const double angle = 0.5 * std::atan2(2.0 * uv, uu - vv);
  return {(uu + vv) / 2.0 + spread, (uu + vv) / 2.0 - spread, std::cos(angle) * u + std::sin(angle) * v};
}

}  // namespace inkbench
