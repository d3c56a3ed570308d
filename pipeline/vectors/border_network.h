// SPDX-License-Identifier: MIT
// The borders between regions, each once: from one place where three or more meet to the next, or round. In:
// a picture of region numbers. Out: borders along the pixels' sides, and for each region what goes round it.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "pipeline/image/image.h"

namespace inkbench {

struct Border {
  std::vector<glm::ivec2> corners;  ///< Of pixels, one step apart, 2 or more.
  bool is_round = false;            ///< Meets no other one; its first corner is repeated at the end.
};

/// A border in its direction, or against it.
struct BorderUse {
  size_t border = 0;
  bool is_backwards = false;

  bool operator==(const BorderUse&) const = default;
};

/// Borders end to end round a region or one of its holes; the region lies on their right, seen along them
/// with y down.
using BorderRing = std::vector<BorderUse>;

struct BorderNetwork {
  glm::ivec2 size{0};  ///< Of the picture.
  std::vector<Border> borders;
  std::vector<std::vector<BorderRing>> rings;  ///< Of each region.
};

/// `regions`: H x W x 1, numbers from 0 on, whose pixels are connected across their sides. The image's edges
/// are borders, too.
BorderNetwork border_network(const ImageOf<int>& regions);

}  // namespace inkbench
