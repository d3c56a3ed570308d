// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cassert>
#include <cfloat>
#include <cmath>
#include <glm/geometric.hpp>

#include "pipeline/mesh/polygon_soup.h"
#include "pipeline/mesh/weld.h"

namespace inkbench {
namespace {

/// Ten times what rounding to floats leaves between equal corners of a model around the origin.
constexpr double kShareOfDiagonal = 1e-6;
/// Of a model far from the origin, whose floats are coarser than that.
constexpr double kFloatSteps = 4;

/// 0 where no two finite points differ.
double merge_distance(const std::vector<glm::vec3>& points) {
  glm::dvec3 low(INFINITY), high(-INFINITY);
  for (const glm::dvec3 point : points) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z)) continue;
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  if (!(low.x <= high.x)) return 0.0;
  const glm::dvec3 largest = glm::max(glm::abs(low), glm::abs(high));
  return std::max(kShareOfDiagonal * glm::length(high - low),
                  kFloatSteps * FLT_EPSILON * std::max({largest.x, largest.y, largest.z}));
}

}  // namespace

void merge_rounded_corners(PolygonSoup& soup) {
  assert(soup.normals.empty());
  const double distance = merge_distance(soup.points);
  if (!(distance > 0.0)) return;
  std::vector<uint32_t> kept = first_within(soup.points, distance);  // then its number among the kept ones
  size_t count = 0;
  for (size_t i = 0; i < kept.size(); ++i) {
    const bool is_first = kept[i] == i;
    if (is_first) soup.points[count] = soup.points[i];
    kept[i] = is_first ? static_cast<uint32_t>(count++) : kept[kept[i]];
  }
  soup.merged_points = soup.points.size() - count;
  soup.points.resize(count);
  for (int32_t& corner : soup.corners) {
    if (corner >= 0 && corner < static_cast<int64_t>(kept.size()))
      corner = static_cast<int32_t>(kept[corner]);
  }
}

}  // namespace inkbench
