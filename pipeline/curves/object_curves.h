// SPDX-License-Identifier: MIT
// The front of the curves of meshes: models and camera in; curves of all classes out, hidden ones with the
// number of surfaces before them.
#pragma once

#include <span>

#include "pipeline/curves/covering.h"

namespace inkbench {

/// Cuts between two of the models, by their places in the list, the first one's first.
struct ModelCuts {
  int first = 0, second = 0;
  const SurfaceCuts* cuts = nullptr;
};

/// Curves of one chain follow each other; chains in order of class and model. Deterministic.
Curves object_curves(std::span<const CurveModel> models, std::span<const ModelCuts> cuts,
                     const CameraParams& camera, int width_px, int height_px, const CurvesParams& params);

}  // namespace inkbench
