// SPDX-License-Identifier: MIT
#include "app/workbench/value_histogram.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "pipeline/image/finite_range.h"

namespace inkbench {

int64_t ValueHistogram::largest() const {
  int64_t result = 0;
  for (const std::vector<int64_t>& counts : channels) {
    for (const int64_t count : counts) result = std::max(result, count);
  }
  return result;
}

ValueHistogram histogram_of(const Image& image, int bins, float most) {
  assert(bins > 0);
  ValueHistogram histogram;
  const auto channels = static_cast<size_t>(image.channels);
  histogram.channels.assign(channels, std::vector<int64_t>(static_cast<size_t>(bins)));
  const std::optional<FiniteRange> range = finite_range(image);
  if (!range) return histogram;
  const float low = std::min(range->low, most), high = std::min(range->high, most);
  histogram.low = low;
  histogram.high = high;
  const double scale = high > low ? bins / (static_cast<double>(high) - low) : 0.0;
  for (size_t i = 0; i < image.samples.size(); ++i) {
    const float value = image.samples[i];
    if (!std::isfinite(value)) continue;
    const auto bin = static_cast<int>((static_cast<double>(std::min(value, most)) - low) * scale);
    ++histogram.channels[i % channels][static_cast<size_t>(std::min(bin, bins - 1))];
  }
  return histogram;
}

float bar_height(int64_t count, int64_t largest, bool log) {
  if (count <= 0 || largest <= 0) return 0.0F;
  if (!log) return static_cast<float>(static_cast<double>(count) / static_cast<double>(largest));
  return static_cast<float>(std::log1p(static_cast<double>(count)) /
                            std::log1p(static_cast<double>(largest)));
}

}  // namespace inkbench
