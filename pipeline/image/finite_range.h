// SPDX-License-Identifier: MIT
// The range that an image's samples span. In: raw values. Out: the smallest and largest of those that are
// finite.
#pragma once

#include <optional>

#include "pipeline/image/image.h"

namespace inkbench {

struct FiniteRange {
  float low = 0.0F, high = 0.0F;
};

/// Over all channels; none where no sample is finite.
std::optional<FiniteRange> finite_range(const Image& image);

}  // namespace inkbench
