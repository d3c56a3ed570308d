// SPDX-License-Identifier: MIT
// Apparent ridges: where a surface bends most as the eye sees it, which is more the more it turns away. In: a
// smooth surface, the eye. Out: lines through its faces on the side that faces the eye, hidden parts
// included. Source: Judd, Durand and Adelson, "Apparent ridges for line drawing", 2007.
#pragma once

#include <vector>

#include "pipeline/lines/lines.h"
#include "pipeline/lines/smooth_surface.h"
#include "pipeline/lines/viewpoint.h"

namespace inkbench {

/// How fast the normal turns as one moves in the picture: the view-dependent curvature q1 of the paper (3.1),
/// the largest singular value of Q = S P^-1, where P projects steps along the surface onto the picture.
struct ApparentCurvature {
  double size = 0.0;          ///< 1 / length.
  glm::dvec3 direction{0.0};  ///< The step along the surface that shows as a unit step in the direction of q1
                              ///< (P^-1 t1); its sign arbitrary.
};

/// `normal` and `to_eye` are of unit length. Where the surface is seen edge on q1 grows without end: normals
/// count as at least a thousandth (cosine) away from that.
ApparentCurvature apparent_curvature(const SymmetricTensor& curvature, const glm::dvec3& normal,
                                     const glm::dvec3& to_eye);

struct ApparentRidgeParams {
  double limit = 0.0;       ///< Least q1, 1 / length.
  double weak_share = 1.0;  ///< A line that reaches the limit somewhere goes on down to this share.
  double shortest = 0.0;    ///< Least length.
};

/// Maxima of q1 along its own direction, on ridges and in valleys alike.
std::vector<SurfaceLine> apparent_ridges(const SmoothSurface& surface, const Viewpoint& eye,
                                         const ApparentRidgeParams& params);

}  // namespace inkbench
