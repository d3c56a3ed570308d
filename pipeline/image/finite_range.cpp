// SPDX-License-Identifier: MIT
#include "pipeline/image/finite_range.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace inkbench {

std::optional<FiniteRange> finite_range(const Image& image) {
  float low = std::numeric_limits<float>::infinity();
  float high = -low;
  for (const float value : image.samples) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (low > high) return std::nullopt;
  return FiniteRange{low, high};
}

}  // namespace inkbench
