// SPDX-License-Identifier: MIT
// How small a model's details are: the length that thresholds of `curves.*` are multiples of.
#pragma once

#include "pipeline/lines/smooth_surface.h"

namespace inkbench {

/// The smaller one of a hundredth of a gentle radius, over which nine tenths of all principal curvatures bend
/// more (both of every point count, without their sign), and a twentieth of the bounding sphere's radius,
/// about the bounding box's middle; in the surface's unit, 0 without points. Source: DeCarlo and
/// Rusinkiewicz, rtsc 1.6, `compute_feature_size`, which looks at 500 points drawn at random and takes the
/// smallest sphere.
double feature_size(const SmoothSurface& surface);

}  // namespace inkbench
