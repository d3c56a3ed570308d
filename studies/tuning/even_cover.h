// SPDX-License-Identifier: MIT
// Points that fill a search space evenly, to look everywhere before looking closely. In: a space, how many
// points at most. Out: points, the same for the same seed.
#pragma once

#include <cstdint>

#include "studies/tuning/search_space.h"

namespace inkbench {

/// With at most two numbers among the sides a grid, its ends on the box's, for every combination of choices,
/// as fine as `most` allows; otherwise, or where that is fewer than five points a side, Halton's sequence
/// (Halton 1960), turned by what follows from the seed. At least one point.
std::vector<Point> even_cover(const SearchSpace& space, int most, uint64_t seed);

}  // namespace inkbench
