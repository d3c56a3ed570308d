// SPDX-License-Identifier: MIT
// Strokes that stay the same from frame to frame, so that their paint and their wobble do not jump (compare
// Kalnins et al., Coherent Stylized Silhouettes, 2003). In: a frame's paths, the strokes of the frame before;
// both know what of the meshes they lie on. Out: the paths with the numbers, directions and `along_px` of the
// strokes that they continue.
#pragma once

#include <vector>

#include "pipeline/strokes/stroke_path.h"

namespace inkbench {

/// Each path continues the stroke with which it shares most places, if any: it goes in its direction, takes
/// its number, begins where it began if both are closed, and its `along_px` are shifted as the median of the
/// shared places says. Others stay as they are.
void carry_along(std::vector<StrokePath>& paths, const Strokes& before);

/// What became of one frame's strokes in the next one.
struct StrokeCarrying {
  std::vector<float> shifts_px;  ///< By how much the paint moved along the line, at each shared place.
  int strokes = 0;               ///< Of the first frame, with places.
  int broken = 0;  ///< Of those, whose places go on in none, or in several: at least a tenth of them in each.
};
StrokeCarrying carrying_between(const Strokes& before, const Strokes& now);

/// Median of the shifts' sizes, px; 0 without any.
float median_shift_px(const StrokeCarrying& carrying);

}  // namespace inkbench
