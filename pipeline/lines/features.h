// SPDX-License-Identifier: MIT
// What the reference lines of a mesh need that no view changes: creases, ridges, valleys, curvature. In: the
// full-resolution mesh's topology. Out: features, used for every view and at every level of a ladder.
#pragma once

#include <glm/mat3x3.hpp>
#include <vector>

#include "pipeline/lines/chain.h"
#include "pipeline/lines/mesh_lines.h"
#include "pipeline/lines/smooth_lines.h"

namespace inkbench {

/// The judge's, and how the model is stretched.
struct FeatureParams {
  FeatureParams() : FeatureParams(JudgeParams{}) {}
  explicit FeatureParams(const JudgeParams& judge);

  double crease_angle_deg;
  double smoothing;  ///< In mean edge lengths; see `make_smooth_surface`.
  SmoothLineParams smooth_lines;
  /// The model's scaling, where it is not the same along all axes: angles and curvature are those of the
  /// stretched mesh. Its rotation and place change nothing and may be left out.
  glm::dmat3 stretch{1.0};
};

/// All points are in the mesh's own units, unstretched, except the surface's.
struct MeshFeatures {
  FeatureParams params;
  std::vector<glm::dvec3> crease_points;
  std::vector<Link> creases;                  ///< Mesh edges, between `crease_points`.
  std::vector<Polyline3> ridges_and_valleys;  ///< In order of class.
  SmoothSurface surface;                      ///< Stretched.
};

MeshFeatures make_features(const MeshTopology& full, const FeatureParams& params = {});

/// Suggestive contours for an eye in the mesh's space.
std::vector<Polyline3> suggestive_contours(const MeshFeatures& features, const Viewpoint& eye);

}  // namespace inkbench
