// SPDX-License-Identifier: MIT
// Two pictures compared with a maximum and a mean threshold, and the picture of where they differ.
#pragma once

#include "pipeline/image/image.h"

namespace inkbench {

struct PictureDifference {
  int largest = 0;    ///< Of all samples, 0 to 255, with a place's nearest match within one pixel.
  double mean = 0.0;  ///< Of all samples, 0 to 255, place by place.
  Picture picture;    ///< The samples' differences, four times as strong, with 128 added where a pixel has no
                      ///< match.
};

/// Both must be of one size, with 3 channels. For `largest`, a pixel may match any of the other's 3 x 3
/// pixels around its place: a line that another rasteriser puts one pixel aside is not a difference, one that
/// is missing is.
PictureDifference compare(const Picture& expected, const Picture& actual);

}  // namespace inkbench
