// SPDX-License-Identifier: MIT
#include "pipeline/curves/feature_size.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "pipeline/lines/principal.h"

namespace inkbench {
namespace {

constexpr double kGentleShare = 0.1;
constexpr double kShareOfGentleRadius = 0.01;
constexpr double kShareOfBounds = 0.05;

double bounding_radius(const std::vector<glm::dvec3>& positions) {
  glm::dvec3 low = positions[0], high = positions[0];
  for (const glm::dvec3& position : positions) {
    low = glm::min(low, position);
    high = glm::max(high, position);
  }
  double radius = 0.0;
  for (const glm::dvec3& position : positions)
    radius = std::max(radius, glm::distance(position, 0.5 * (low + high)));
  return radius;
}

/// A tenth of all principal curvatures are smaller, without their sign.
double gentle_curvature(const SmoothSurface& surface) {
  std::vector<double> sizes;
  sizes.reserve(2 * surface.positions.size());
  for (size_t i = 0; i < surface.positions.size(); ++i) {
    const Principal principal = principal_of(surface.curvature[i], surface.normals[i]);
    sizes.push_back(std::abs(principal.larger));
    sizes.push_back(std::abs(principal.smaller));
  }
  const auto gentle =
      sizes.begin() + static_cast<ptrdiff_t>(kGentleShare * static_cast<double>(sizes.size()));
  std::nth_element(sizes.begin(), gentle, sizes.end());
  return *gentle;
}

}  // namespace

double feature_size(const SmoothSurface& surface) {
  if (surface.positions.empty()) return 0.0;
  const double most = kShareOfBounds * bounding_radius(surface.positions);
  const double curvature = gentle_curvature(surface);
  return curvature * most > kShareOfGentleRadius ? kShareOfGentleRadius / curvature : most;
}

}  // namespace inkbench
