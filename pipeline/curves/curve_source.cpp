// SPDX-License-Identifier: MIT
#include "pipeline/curves/curve_source.h"

#include "pipeline/curves/feature_size.h"
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
  drawn_edges_.assign(topology_.edges.size(), 0);
  for (const auto& edges : {boundaries_, creases_}) {
    for (const uint32_t edge : edges) drawn_edges_[edge] = 1;
  }
  if (params.intersection) own_cuts_ = cut_with_itself(to_cut());
  if (!needs_surface(params)) return;
  surface_ = std::make_unique<SmoothSurface>(
      make_smooth_surface(topology_, params.crease_angle, params.smoothing, stretch));
  if (params.silhouette == SilhouetteKind::smooth) smooth_silhouettes_ = SmoothSilhouettes(*surface_);
  feature_size_ = inkbench::feature_size(*surface_);
  const auto add = [&](bool is_wanted, LineClass line_class, double limit) {
    if (!is_wanted) return;
    for (Polyline3& line : inkbench::ridges_and_valleys(
             *surface_, smooth_line_params(params, limit, *surface_, feature_size_))) {
      if (line.line_class == line_class) ridges_and_valleys_.push_back(std::move(line));
    }
  };
  add(params.ridge, LineClass::ridge, params.ridge_limit);
  add(params.valley, LineClass::valley, params.valley_limit);
}

SmoothLineParams smooth_line_params(const CurvesParams& params, double ridge_limit,
                                    const SmoothSurface& surface, double feature_size) {
  const JudgeParams judge;
  const double radius = surface.radius / (feature_size > 0.0 ? feature_size : 1.0);  // in feature sizes
  return {.suggestive_derivative = params.suggestive_limit * radius * radius,
          .suggestive_angle_deg = params.suggestive_angle,
          .ridge_curvature = ridge_limit * radius,
          .ridge_sharpness = judge.ridge_sharpness,
          .ridge_anisotropy = judge.ridge_anisotropy,
          .weak_share = params.weak_share,
          .shortest = radius > 0.0 ? params.shortest / radius : 0.0};
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
    decisive.suggestive = true;  // whichever of them: there is a surface
    decisive.ridge = params.ridge;
    decisive.valley = params.valley;
    if (params.ridge) decisive.ridge_limit = params.ridge_limit;
    if (params.valley) decisive.valley_limit = params.valley_limit;
    if (params.ridge || params.valley) {
      decisive.weak_share = params.weak_share;
      decisive.shortest = params.shortest;
    }
  }
  return group_text(decisive);
}

}  // namespace inkbench
