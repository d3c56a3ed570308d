// SPDX-License-Identifier: MIT
// A shaded picture as flat areas with smooth borders, which neighbours share: each border is traced, evened
// and fitted once. In: a picture. Out: areas in the order in which they are drawn.
#pragma once

#include <vector>

#include "pipeline/image/image.h"
#include "pipeline/vectors/cubic_path.h"
#include "pipeline/vectors/flat_colours.h"

namespace inkbench {

struct RegionOptions {
  int steps = 12;          ///< Of smooth shading (`flat_colours`).
  double least_px = 12.0;  ///< Smaller regions, in square px, are merged into a neighbour.
  double error_px = 0.5;   ///< Of fitting borders, after they are evened.
  double sample_px = 1.0;  ///< How large a sample of the picture is.
};

struct TracedRegion {
  Rgb colour{};
  double area = 0.0;                ///< Square px.
  std::vector<CubicPath> outlines;  ///< Closed; what they go round at all lies in it.
};

/// Large ones first. Borders lie within `kMostMoved` samples and `error_px` of the middles of the samples'
/// sides, those of the image on its edges. `object_ids` as in `flat_colours`.
std::vector<TracedRegion> traced_regions(const Image& shaded, const Image& object_ids,
                                         const RegionOptions& options);

}  // namespace inkbench
