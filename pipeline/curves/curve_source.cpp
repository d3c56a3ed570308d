// SPDX-License-Identifier: MIT
#include "pipeline/curves/curve_source.h"

#include "pipeline/lines/mesh_lines.h"
#include "pipeline/settings/settings.h"

namespace inkbench {
namespace {

bool needs_surface(const CurvesParams& params) {
  return params.silhouette == SilhouetteKind::smooth || params.suggestive || params.ridge || params.valley ||
         params.apparent_ridge;
}

}  // namespace

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
      creases_(crease_edges(topology_, params.crease_angle, stretch)),
      stretch_(stretch) {
  if (params.intersection) own_cuts_ = cut_with_itself(faces_);
  if (!needs_surface(params)) return;
  surface_ = std::make_unique<SmoothSurface>(
      make_smooth_surface(topology_, params.crease_angle, params.smoothing, stretch));
  if (params.silhouette == SilhouetteKind::smooth) smooth_silhouettes_ = SmoothSilhouettes(*surface_);
}

bool CurveSource::is_parted(uint32_t edge) const {
  const auto uses = topology_.uses_of(topology_.edges[edge]);
  const auto crossing = [&](const MeshTopology::Use& use) {
    const auto& edges = topology_.face_edges[use.face];
    const size_t i = edges[0] == edge ? 0 : edges[1] == edge ? 1 : 2;
    return surface_->crossings[use.face][i];
  };
  return uses.size() != 2 || crossing(uses[0]) != crossing(uses[1]);
}

std::string source_text(const CurvesParams& params) {
  CurvesParams decisive;
  decisive.crease_angle = params.crease_angle;
  decisive.intersection = params.intersection;
  if (needs_surface(params)) {
    decisive.silhouette = params.silhouette;
    decisive.smoothing = params.smoothing;
    decisive.ridge = true;
  }
  return group_text(decisive);
}

}  // namespace inkbench
