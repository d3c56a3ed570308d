// SPDX-License-Identifier: MIT
// Flat areas as elements of an SVG file, to lie below lines. In: traced regions. Out: a group.
#pragma once

#include <string>

#include "pipeline/vectors/traced_regions.h"

namespace inkbench {

/// The group `regions`: a path for each region in its colour, large ones first, with a line of the same
/// colour round it, 0.5 px wide, so that nothing shows between neighbours.
std::string regions_svg(const std::vector<TracedRegion>& regions);

}  // namespace inkbench
