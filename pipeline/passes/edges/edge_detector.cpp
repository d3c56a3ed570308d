// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/edge_detector.h"

#include <algorithm>

#include "pipeline/passes/edges/dihedral_detector.h"
#include "pipeline/passes/edges/paper_detector.h"

namespace inkbench {

bool EdgeDetector::sees_facets(const Settings& settings) const {
  const bool flat_model = std::any_of(
      settings.models.begin(), settings.models.end(),
      [](const ModelParams& model) { return model.visible && model.normals == ModelNormals::flat; });
  return has_normal_term(settings) && (flat_model || settings.mesh.normals == LevelNormals::flat);
}

std::vector<const EdgeDetector*> edge_detectors() {
  return {&paper_detector(), &dihedral_detector()};
}

const EdgeDetector& edge_detector(const Settings& settings) {
  if (settings.edges.method == EdgeMethod::dihedral) return dihedral_detector();
  return *edge_detectors().front();
}

}  // namespace inkbench
