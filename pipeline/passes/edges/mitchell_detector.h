// SPDX-License-Identifier: MIT
// Mitchell, Brennan and Card's detector (2002) beside the GPU: its comparisons on raw buffers, and why a
// pixel is a line by them.
#pragma once

#include "pipeline/passes/edges/edge_class.h"
#include "pipeline/passes/edges/edge_detector.h"

namespace inkbench {

struct MitchellMaps {
  SurfaceMaps surfaces;
  const Image* albedo = nullptr;  ///< H x W x 3 or more.
};

/// The largest difference to one of the four neighbours, and that neighbour; among equal ones the first of
/// left, right, above, below.
struct MitchellTerm {
  double value = 0;
  Offset at;
};

struct MitchellTerms {
  MitchellTerm angle;   ///< Degrees; none from or to where no model is.
  MitchellTerm depth;   ///< Share of far.
  MitchellTerm id;      ///< 1 where it differs.
  MitchellTerm albedo;  ///< Of a channel; none from or to where no model is.
  double strength(const MitchellParams& params) const;
  /// Do only the colours reach the share `weak` of their limit?
  bool is_material(const MitchellParams& params, double weak) const;
};

MitchellTerms mitchell_terms(const MitchellMaps& maps, int x, int y);

const EdgeDetector& mitchell_detector();

}  // namespace inkbench
