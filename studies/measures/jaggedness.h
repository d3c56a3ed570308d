// SPDX-License-Identifier: MIT
// How straight a drawn line runs along the line that it stands for. In: the unthinned prediction and the
// reference polylines. Out: sums from which jaggedness and bias follow, poolable by addition.
#pragma once

#include <optional>
#include <span>

#include "pipeline/lines/line_map.h"
#include "pipeline/lines/lines.h"

namespace inkbench {

/// Where the ink lies beside the polylines, over all samples that have ink.
struct LineOffsets {
  int64_t samples = 0;
  double sum = 0;                 ///< Of the signed offsets e, in px.
  double squared_wobble_sum = 0;  ///< Of (e - its moving mean)^2.

  void add(const LineOffsets& other);
};

/// The centroid of the ink on the straight piece of 8 px through (x, y) along the unit vector (normal_x,
/// normal_y): its signed distance from (x, y) in px. Each ink pixel counts with the length that the piece has
/// in its square [x, x + 1) x [y, y + 1), exactly, not by samples. Nothing where the piece meets no ink.
std::optional<double> ink_offset(const LineMap& ink, double x, double y, double normal_x, double normal_y);

/// Samples each polyline at arc lengths 0, 1, 2, ... px up to its length. The normal is the direction of
/// travel turned by +90 degrees from x to y: in the picture, to the right of travel, where e is positive. At
/// a corner the piece that begins there decides. Left out: samples without ink in reach, and those in the
/// image's ignored border or outside the image. The moving mean of a sample is over the samples at most 7 px
/// of arc length before and after it that exist; closed lines are not wrapped. A piece with an end that is
/// not finite is left out, as if its ends were one. `ink` is without its border.
LineOffsets line_offsets(const LineMap& ink, std::span<const Polyline> polylines);

}  // namespace inkbench
