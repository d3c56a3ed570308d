// SPDX-License-Identifier: MIT
// The Laplacian of 1/z beside the GPU: its equation on the raw depth map, and why a pixel is a line by it.
#pragma once

#include "pipeline/passes/edges/edge_class.h"
#include "pipeline/passes/edges/edge_detector.h"

namespace inkbench {

struct LaplacianTerm {
  double bend = 0;  ///< max over 4 directions |w(+) + w(-) - 2 w| / (w delta); 0 where no model is.
  Offset at;        ///< One of the direction's two neighbours.
};

/// Of the pixel (x, y) of the depth map, H x W x 1. Directions that leave the image are left out.
LaplacianTerm laplacian_term(const Image& depth, const LensBlock& lens, int x, int y);

const EdgeDetector& laplacian_detector();

}  // namespace inkbench
