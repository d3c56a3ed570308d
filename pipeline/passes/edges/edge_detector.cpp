// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/edge_detector.h"

#include "pipeline/passes/edges/dihedral_detector.h"
#include "pipeline/passes/edges/paper_detector.h"

namespace inkbench {

std::vector<const EdgeDetector*> edge_detectors() {
  return {&paper_detector(), &dihedral_detector()};
}

const EdgeDetector& edge_detector(const Settings& settings) {
  if (settings.edges.method == EdgeMethod::dihedral) return dihedral_detector();
  return *edge_detectors().front();
}

}  // namespace inkbench
