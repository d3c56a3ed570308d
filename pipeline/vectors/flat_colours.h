// SPDX-License-Identifier: MIT
// Shading as few flat colours. In: a shaded picture. Out: for each pixel a number, and the colours of the
// numbers.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "pipeline/image/image.h"

namespace inkbench {

using Rgb = std::array<uint8_t, 3>;

struct FlatPicture {
  ImageOf<int> numbers;      ///< H x W x 1.
  std::vector<Rgb> colours;  ///< Of the numbers; each once.
};

/// An object of that many colours at most, those that only rounding keeps apart taken for one, keeps them.
inline constexpr size_t kMostFlatColours = 32;

/// `shaded`: H x W x 3 or more, 0 to 1 as it is shown; what lies outside is shown as the nearer end.
/// `object_ids`: H x W x 1; empty where all is one object. Of a smoothly shaded object the colours are cut
/// into boxes whose longest side is at most 1.5 / `steps`, in equal parts; each takes their mean.
FlatPicture flat_colours(const Image& shaded, const Image& object_ids, int steps);

}  // namespace inkbench
