// SPDX-License-Identifier: MIT
#include "pipeline/curves/curve_source.h"

#include "pipeline/lines/mesh_lines.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

FaceRings::FaceRings(const MeshTopology& topology)
    : starts_(topology.positions.size() + 1, 0), faces_(topology.faces.size() * 3) {
  for (const auto& face : topology.faces) {
    for (const uint32_t point : face) ++starts_[point + 1];
  }
  for (size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  std::vector<uint32_t> filled(starts_.begin(), starts_.end() - 1);
  for (uint32_t f = 0; f < topology.faces.size(); ++f) {
    for (const uint32_t point : topology.faces[f]) faces_[filled[point]++] = f;
  }
}

CurveSource::CurveSource(const Mesh& mesh, const CurvesParams& params, const glm::dmat3& stretch)
    : topology_(make_topology(mesh)),
      faces_(topology_),
      rings_(topology_),
      silhouettes_(topology_),
      boundaries_(boundary_edges(topology_, params.crease_angle)),
      creases_(crease_edges(topology_, params.crease_angle, stretch)) {
  if (params.intersection) own_cuts_ = cut_with_itself(faces_);
}

std::string source_text(const CurvesParams& params) {
  CurvesParams decisive;
  decisive.crease_angle = params.crease_angle;
  decisive.intersection = params.intersection;
  return group_text(decisive);
}

}  // namespace inkbench
