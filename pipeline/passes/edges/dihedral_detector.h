// SPDX-License-Identifier: MIT
// Ours: a line is where neighbouring pixels' planes meet at a large angle or lie apart, or ids differ. Its
// passes are pairs, shaded_pairs, dihedral and dihedral_place.
#pragma once

#include "pipeline/passes/edges/edge_detector.h"

namespace inkbench {

const EdgeDetector& dihedral_detector();

}  // namespace inkbench
