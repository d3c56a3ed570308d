// SPDX-License-Identifier: MIT
// The decision of `dihedral` worked out beside the GPU: which of a pixel's four sides are lines of its own.
// In: raw `pair_angles` and `pair_gaps`, the limits. Out: numbers.
#pragma once

#include <array>

#include "pipeline/image/image.h"
#include "pipeline/passes/edges/explanation.h"
#include "pipeline/settings/dihedral_params.h"
#include "pipeline/settings/line_params.h"

namespace inkbench {

/// One side of a pixel, whosever line it is.
struct PixelSide {
  Offset to;  ///< The neighbour.
  double angle_deg = 0;
  double gap_px = 0;  ///< 0 where the planes meet between both pixels' centres.
  bool is_object_border = false;
  bool is_own = false;    ///< The line that it may be is this pixel's.
  double strength = 0;    ///< 1 = at the limit.
  double meets_at = 0.5;  ///< Where planes meet, in pixels from the centre.
  EdgeClass line_class = EdgeClass::none;
};

/// To the right, above, to the left and below; the image's border has no gap and no angle. `angles` and
/// `gaps` are H x W x 2; the pixel must be inside. Equals shaders/lib/dihedral.glsl.
std::array<PixelSide, 4> pixel_sides(const Image& angles, const Image& gaps, const DihedralParams& params,
                                     double weak, int x, int y);

}  // namespace inkbench
