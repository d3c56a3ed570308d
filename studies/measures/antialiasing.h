// SPDX-License-Identifier: MIT
// How far antialiased lines are from what they should be: the same placed lines rasterised at 8 x 8 and
// filtered. In: three coverages of one drawing. Out: sums of squares, from which the RMS differences follow.
#pragma once

#include <cstdint>
#include <optional>

#include "pipeline/image/image.h"

namespace inkbench {

/// Pools by addition.
struct AntialiasingTally {
  int64_t pixels = 0;          ///< Within 3 px of a line.
  double drawn_squares = 0;    ///< Of differences from the wanted coverage.
  double aliased_squares = 0;  ///< The same of the lines without antialiasing.

  void add(const AntialiasingTally& other);
  /// Root of the mean square; none where there is no line.
  std::optional<double> drawn_rms() const;
  std::optional<double> aliased_rms() const;
};

/// Coverages 0 to 1, each H x W x 1: as drawn, without antialiasing, and as wanted. A pixel has a line where
/// the wanted coverage is above 0.
AntialiasingTally tally_antialiasing(const Image& drawn, const Image& aliased, const Image& wanted);

}  // namespace inkbench
