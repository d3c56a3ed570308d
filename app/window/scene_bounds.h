// SPDX-License-Identifier: MIT
// The box around what the scene shows.
#pragma once

#include "pipeline/pipeline.h"

namespace inkbench {

/// In world space, of the visible models or of the main one alone; the origin where there is none. Errors
/// (input): a mesh cannot be read.
Bounds bounds_in_world(const Frame& frame, bool only_main_model);

}  // namespace inkbench
