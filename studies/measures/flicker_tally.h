// SPDX-License-Identifier: MIT
// How lines come and go between two frames of a camera path (measures.md section 8). In: each frame's lines
// and depth, and where its surface points are in the other. Out: counts that pool over the path.
#pragma once

#include <cstdint>
#include <optional>

#include "pipeline/lines/line_map.h"
#include "pipeline/settings/camera.h"

namespace inkbench {

/// Pools by addition.
struct FlickerCounts {
  int64_t died = 0, born = 0;
  int64_t carried = 0;  ///< Both ways.

  void add(const FlickerCounts& other);
  /// (died + born) / carried; none where nothing was carried.
  std::optional<double> share() const;
};

/// Of the drawn lines and of the wanted ones; those that were not asked for stay 0.
struct FlickerTally {
  FlickerCounts drawn, wanted;

  void add(const FlickerTally& other);
};

/// What is seen in a frame.
struct SeenSurface {
  const Image& depth;   ///< H x W x 1, distance along the view axis / far; 1 where no model is.
  CameraParams camera;  ///< That saw it.
};

/// H x W x 4 of `MotionPass`, to the other frame.
using MotionMap = Image;

/// Carries the lines of `before` to `now` (what finds none there died) and those of `now` back (born). A line
/// pixel moves as the surface nearest to the eye among the pixels within the tolerance: a contour belongs to
/// what it bounds, not to what lies behind. It counts where that surface's point is visible (`DepthTest`) and
/// the whole disc of the tolerance around where it lands lies within the measured part of the image. Lines:
/// as `counted_lines` gives them. Places are taken to 1/256 px, so that rounding decides nothing. All images
/// have one size.
class LineCarrier {
 public:
  LineCarrier(const SeenSurface& before, const MotionMap& to_now, const SeenSurface& now,
              const MotionMap& to_before, double tolerance_px)
      : before_(before), now_(now), to_now_(to_now), to_before_(to_before), tolerance_px_(tolerance_px) {}

  FlickerCounts counts(const LineMap& before, const LineMap& now) const;

 private:
  SeenSurface before_, now_;
  const MotionMap& to_now_;
  const MotionMap& to_before_;
  double tolerance_px_;
};

}  // namespace inkbench
