// SPDX-License-Identifier: MIT
// Exact Euclidean distances from pixels to the nearest true pixel of a line map, as squared whole numbers, so
// that no comparison depends on rounding. Near distances for whole bands of rows at once, far ones for the
// pixels that ask. Distances are between pixel centres.
#pragma once

#include <limits>

#include "pipeline/lines/line_map.h"

namespace inkbench {

/// The squared distance to a map without a true pixel.
inline constexpr int64_t kInfinitelyFar = std::numeric_limits<int64_t>::max();

/// Squared distances above this are cut down to it by `near_distances`.
inline constexpr int kNearLimitPx = 10;
inline constexpr int kNearLimitSquared = kNearLimitPx * kNearLimitPx;

/// For rows [first_row, end_row) of `to`: min(squared distance to the nearest true pixel of the whole map,
/// 100), one byte a pixel, into `out` ((end_row - first_row) x W).
void near_distances(const LineMap& to, int first_row, int end_row, std::vector<uint8_t>& out);

/// The squared distance from each pixel of `from` to the nearest true pixel of `to`, untruncated;
/// kInfinitelyFar where there is none. `from` is sorted by rows, as `pixels_of` gives it. Takes time in
/// proportion to the rows asked about times W, and memory to the true pixels.
/// Source: the row envelope of Meijster, Roerdink and Hesselink, "A general algorithm for computing distance
/// transforms in linear time", 2000.
std::vector<int64_t> squared_distances(std::span<const Pixel> from, const LineMap& to);

/// For each pixel of `from` (sorted by rows), the squared distance to the nearest false pixel of `map`. A map
/// without any gives kInfinitelyFar; what lies outside the image does not count.
std::vector<int64_t> squared_distances_to_background(std::span<const Pixel> from, const LineMap& map);

}  // namespace inkbench
