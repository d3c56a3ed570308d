// SPDX-License-Identifier: MIT
// How often values occur in a buffer, to be drawn. In: raw values. Out: counts of bins of equal width, by
// channel.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "pipeline/image/image.h"

namespace inkbench {

struct ValueHistogram {
  float low = 0.0F, high = 0.0F;               ///< The smallest and largest finite value.
  std::vector<std::vector<int64_t>> channels;  ///< A count a bin; the bins divide low to high.

  int64_t largest() const;
};

/// Values that are not finite count nowhere; without any others low and high are 0. Where all values are the
/// same, all are in the first bin. Larger ones than `most` count as that.
ValueHistogram histogram_of(const Image& image, int bins, float most = std::numeric_limits<float>::max());

/// The height of a bar of `count` where the highest is 1: in proportion, or with each tenfold count as high a
/// step (0 stays 0, and 1 is seen).
float bar_height(int64_t count, int64_t largest, bool log);

}  // namespace inkbench
