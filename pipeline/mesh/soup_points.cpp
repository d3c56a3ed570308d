// SPDX-License-Identifier: MIT
#include "pipeline/mesh/soup_points.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "pipeline/mesh/weld.h"

namespace inkbench {
namespace {

constexpr double kFarInExtents = 16.0;
constexpr double kSmallestExtent = 1e-6, kLargestExtent = 1e6;
/// Ten times what rounding to floats leaves between equal corners of a model around the origin.
constexpr double kShareOfDiagonal = 1e-6;
/// Of a model far from the origin, whose floats are coarser than that.
constexpr double kFloatSteps = 4;

struct Extent {
  glm::dvec3 low{INFINITY}, high{-INFINITY};

  double longest() const { return std::max({high.x - low.x, high.y - low.y, high.z - low.z}); }
  double farthest() const {
    const glm::dvec3 far = glm::max(glm::abs(low), glm::abs(high));
    return std::max({far.x, far.y, far.z});
  }
};

Extent extent_of(const PolygonSoup& soup, const std::vector<bool>& used) {
  Extent extent;
  for (size_t i = 0; i < soup.points.size(); ++i) {
    if (!used[i]) continue;
    extent.low = glm::min(extent.low, soup.points[i]);
    extent.high = glm::max(extent.high, soup.points[i]);
  }
  return extent;
}

void choose_frame(const Extent& extent, SoupPoints& points) {
  const double longest = extent.longest();
  if (!(longest > 0.0)) return;
  if (longest < kSmallestExtent || longest > kLargestExtent)
    points.unit = std::exp2(std::round(std::log2(longest)));
  if (extent.farthest() > kFarInExtents * longest)
    points.origin = extent.low + (extent.high - extent.low) / 2.0;
}

}  // namespace

SoupPoints take_points(const PolygonSoup& soup, const std::vector<bool>& used) {
  const Extent extent = extent_of(soup, used);
  SoupPoints points;
  choose_frame(extent, points);
  points.places.reserve(soup.points.size());
  for (size_t i = 0; i < soup.points.size(); ++i)
    points.places.emplace_back(used[i] ? (soup.points[i] - points.origin) / points.unit : glm::dvec3(NAN));
  points.first = first_at_same_position(points.places);
  if (!soup.corners_are_rounded) return points;
  const double distance = std::max(kShareOfDiagonal * glm::length(extent.high - extent.low),
                                   kFloatSteps * FLT_EPSILON * extent.farthest());
  if (!(distance > 0.0) || !std::isfinite(distance)) return points;
  const std::vector<uint32_t> near = first_within(points.places, distance / points.unit);
  for (size_t i = 0; i < near.size(); ++i) {
    if (used[i] && points.first[i] == i && near[i] != i) ++points.merged_by_rounding;
  }
  points.first = near;
  return points;
}

}  // namespace inkbench
