// SPDX-License-Identifier: MIT
// Of traced curves what the meshes' curves do not explain. In: both. Out: the parts of the traced ones that
// no visible curve of a mesh runs along.
#pragma once

#include "pipeline/curves/curve.h"

namespace inkbench {

/// How far a traced curve may lie beside the curve that it is; less than lines that can be told apart.
inline constexpr float kExplainedPx = 2.0F;
/// Shorter remains between explained parts are none.
inline constexpr double kShortestRemainPx = 6.0;

std::vector<Curve> unexplained(const Curves& traced, const Curves& of_objects);

}  // namespace inkbench
