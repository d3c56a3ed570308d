// SPDX-License-Identifier: MIT
// Whether a mesh encloses volume: then nobody outside it ever sees the back of a face.
#pragma once

#include "pipeline/mesh/mesh.h"

namespace inkbench {

/// True when, with equal positions taken as one point, every edge joins exactly two faces of the same
/// orientation and every connected part has its faces outwards (positive signed volume).
bool is_closed_outwards(const Mesh& mesh);

}  // namespace inkbench
