// SPDX-License-Identifier: MIT
// The paper's edge detector (3.4): gradients of depth and normals, the range of each around a pixel, both
// against their k, the sum against a threshold. Its passes are gradient, range and combine.
#pragma once

#include "pipeline/passes/edges/edge_detector.h"

namespace inkbench {

const EdgeDetector& paper_detector();

}  // namespace inkbench
