// SPDX-License-Identifier: MIT
#include "pipeline/curves/curve.h"

#include <glm/geometric.hpp>

namespace inkbench {

double length_px(const Curve& curve) {
  double length = 0.0;
  for (size_t i = 1; i < curve.points.size(); ++i)
    length += glm::distance(glm::dvec2(curve.points[i - 1]), glm::dvec2(curve.points[i]));
  return length;
}

}  // namespace inkbench
