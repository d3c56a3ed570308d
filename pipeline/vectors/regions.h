// SPDX-License-Identifier: MIT
// The connected regions of a picture of numbers, small ones merged into a neighbour. Pixels are connected
// across their sides.
#pragma once

#include <vector>

#include "pipeline/image/image.h"

namespace inkbench {

struct Regions {
  ImageOf<int> region;       ///< H x W x 1: of each pixel, numbered in the order of their first pixels.
  std::vector<int> numbers;  ///< What the region's pixels are.
  std::vector<int> areas;    ///< Pixels.
};

Regions find_regions(const ImageOf<int>& numbers);

/// Regions of fewer pixels than `least`, the smallest first, take the number with which they share the
/// longest border (the lowest of several), until there are none, or nothing is left that they could take.
Regions without_small_regions(ImageOf<int> numbers, int least);

}  // namespace inkbench
