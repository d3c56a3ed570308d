// SPDX-License-Identifier: MIT
// Decaudin's detector (1996) beside the GPU: its equations on raw buffers, and why a pixel is a line by them.
#pragma once

#include "pipeline/passes/edges/edge_detector.h"
#include "pipeline/passes/edges/operators.h"

namespace inkbench {

/// Of one map: the range of its gradient around a pixel.
struct DecaudinTerm {
  int channel = 0;                             ///< Of the normal map: 0 to 2.
  std::array<std::optional<float>, 9> around;  ///< Gradients.
  RangeAround range;
  double ratio = 0;  ///< (gmax - gmin) / k
};

struct DecaudinTerms {
  DecaudinTerm depth;
  DecaudinTerm normal;  ///< Of the component whose range is the largest.
  /// 2 (larger ratio)^2, so that 1 is half ink.
  double strength() const;
};

/// Of the pixel (x, y) of the depth map, H x W x 1, and the normal map, H x W x 3.
DecaudinTerms decaudin_terms(const Image& depth, const Image& normal, const DecaudinParams& params, int x,
                             int y);

const EdgeDetector& decaudin_detector();

}  // namespace inkbench
