// SPDX-License-Identifier: MIT
// Saito and Takahashi's detector (1990) beside the GPU: its equations on raw buffers, and why a pixel is a
// line by them.
#pragma once

#include "pipeline/passes/edges/edge_class.h"
#include "pipeline/passes/edges/edge_detector.h"

namespace inkbench {

/// The depth between the nearest and the farthest visible distance, by the depth map's value: 0 to 1 on
/// surfaces, more where no model is (passes/gbuffer/visible_depth.h).
double visible_depth(const LensBlock& lens, double nearest, double farthest, double depth);

struct SaitoTakahashiTerms {
  double profile = 0;  ///< First order of the visible depth.
  double crease = 0;   ///< Second order.
  /// max(profile / limit, min(crease / limit, 2))
  double strength(const SaitoTakahashiParams& params) const;
};

/// Of the pixel (x, y) of the visible depth, H x W x 1.
SaitoTakahashiTerms saito_takahashi_terms(const Image& visible_depth, int x, int y);

const EdgeDetector& saito_takahashi_detector();

}  // namespace inkbench
