// SPDX-License-Identifier: MIT
// What of a mesh its curves need that no view changes. In: the mesh that is drawn. Out: its edges by class,
// trees for rays and silhouettes, its smooth surface. Made once for a mesh, then read for every view.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "pipeline/curves/silhouette_tree.h"
#include "pipeline/curves/smooth_silhouettes.h"
#include "pipeline/curves/surface_cuts.h"
#include "pipeline/curves/triangle_tree.h"
#include "pipeline/lines/smooth_lines.h"
#include "pipeline/lines/smooth_surface.h"
#include "pipeline/settings/curves_params.h"

namespace inkbench {

/// The faces around each point of a mesh.
class FaceRings {
 public:
  explicit FaceRings(const MeshTopology& topology);
  std::span<const uint32_t> around(uint32_t point) const {
    return {faces_.data() + starts_[point], starts_[point + 1] - starts_[point]};
  }

 private:
  std::vector<uint32_t> starts_, faces_;
};

/// Of one mesh and the parameters that decide it (`source_text`). It does not move: parts look at each other.
class CurveSource {
 public:
  /// `stretch`: as `FeatureParams::stretch`.
  CurveSource(const Mesh& mesh, const CurvesParams& params, const glm::dmat3& stretch);
  CurveSource(const CurveSource&) = delete;
  CurveSource& operator=(const CurveSource&) = delete;

  const MeshTopology& topology() const { return topology_; }
  const TriangleTree& faces() const { return faces_; }
  const FaceRings& rings() const { return rings_; }
  const EdgeSilhouettes& silhouettes() const { return silhouettes_; }
  const std::vector<uint32_t>& boundaries() const { return boundaries_; }
  const std::vector<uint32_t>& creases() const { return creases_; }
  const SurfaceCuts& own_cuts() const { return own_cuts_; }
  CutMesh to_cut() const { return {&faces_, &drawn_edges_}; }

  /// The smooth surface, where the parameters ask for lines of it, stretched; else null.
  const SmoothSurface* surface() const { return surface_.get(); }
  const glm::dmat3& stretch() const { return stretch_; }
  double feature_size() const { return feature_size_; }  ///< Of the surface.
  /// Ridges and valleys, as far as they are asked for, in the surface's space.
  const std::vector<Polyline3>& ridges_and_valleys() const { return ridges_and_valleys_; }
  const SmoothSilhouettes& smooth_silhouettes() const { return smooth_silhouettes_; }
  /// Whether the smooth surface ends at the edge.
  bool is_parted(uint32_t edge) const;

 private:
  MeshTopology topology_;
  TriangleTree faces_;
  FaceRings rings_;
  EdgeSilhouettes silhouettes_;
  std::vector<uint32_t> boundaries_, creases_;
  std::vector<uint8_t> drawn_edges_;  ///< 1 for boundaries and creases.
  SurfaceCuts own_cuts_;
  glm::dmat3 stretch_;
  std::unique_ptr<SmoothSurface> surface_;
  SmoothSilhouettes smooth_silhouettes_;
  double feature_size_ = 0.0;
  std::vector<Polyline3> ridges_and_valleys_;
};

/// The parameters for lines of a smooth surface of this feature size, with `ridge_limit` for ridges and
/// valleys alike. Sharpness and anisotropy are those of the reference lines.
SmoothLineParams smooth_line_params(const CurvesParams& params, double ridge_limit,
                                    const SmoothSurface& surface, double feature_size);

/// What of the parameters decides a source, as text for keys.
std::string source_text(const CurvesParams& params);

}  // namespace inkbench
