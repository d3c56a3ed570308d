// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/edge_detector.h"

#include <algorithm>

#include "pipeline/passes/edges/decaudin_detector.h"
#include "pipeline/passes/edges/dihedral_detector.h"
#include "pipeline/passes/edges/laplacian_detector.h"
#include "pipeline/passes/edges/mitchell_detector.h"
#include "pipeline/passes/edges/paper_detector.h"
#include "pipeline/passes/edges/saito_takahashi_detector.h"

namespace inkbench {

bool EdgeDetector::sees_facets(const Settings& settings) const {
  const bool flat_model = std::any_of(
      settings.models.begin(), settings.models.end(),
      [](const ModelParams& model) { return model.visible && model.normals == ModelNormals::flat; });
  return has_normal_term(settings) && (flat_model || settings.mesh.normals == LevelNormals::flat);
}

std::vector<const EdgeDetector*> edge_detectors() {
  return {&paper_detector(),    &decaudin_detector(),  &saito_takahashi_detector(),
          &mitchell_detector(), &laplacian_detector(), &dihedral_detector()};
}

const EdgeDetector& edge_detector(const Settings& settings) {
  return *edge_detectors().at(static_cast<size_t>(settings.edges.method));
}

}  // namespace inkbench
