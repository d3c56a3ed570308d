// SPDX-License-Identifier: MIT
// Lines of tier 2: where a smooth surface nearly turns away from the eye, and where it bends most. In: a
// smooth surface, and the eye for suggestive contours. Out: lines through its faces, hidden parts included.
#pragma once

#include <vector>

#include "pipeline/lines/lines.h"
#include "pipeline/lines/smooth_surface.h"
#include "pipeline/lines/viewpoint.h"

namespace inkbench {

/// From `judge.*`. Thresholds have no unit: curvature is multiplied by the surface's radius (half the
/// diagonal of its bounding box), its derivative by the radius squared.
struct SmoothLineParams {
  double suggestive_derivative = 0;  ///< Least derivative of radial curvature towards the eye.
  double suggestive_angle_deg = 0;   ///< Least angle between normal and view.
  double ridge_curvature = 0;        ///< Least curvature across a ridge or valley.
  double ridge_sharpness = 0;        ///< Least - k'' / k^3 across it: 0 on an arc, 3 on a parabola.
  double ridge_anisotropy = 0;       ///< Largest share of the curvature along it in that across it.
  double weak_share = 0;             ///< A line that is strong somewhere goes on down to this share.
  double shortest = 0;               ///< Least length, in radii.
};

/// Zeros of the radial curvature, where its derivative in the direction towards the eye is positive, on parts
/// whose smoothed normals face the eye. Source: DeCarlo, Finkelstein, Rusinkiewicz and Santella, "Suggestive
/// contours for conveying shape", 2003, 2.2; the derivative is taken of the linear function whose zeros are
/// traced.
std::vector<Polyline3> suggestive_contours(const SmoothSurface& surface, const Viewpoint& eye,
                                           const SmoothLineParams& params);

/// Maxima of the larger principal curvature along its own direction, where the surface is convex across the
/// line (`ridge`), and the same of the surface turned inside out (`valley`). Source: Ohtake, Belyaev and
/// Seidel, "Ridge-valley lines on meshes via implicit surface fitting", 2004, sections 2 and 5.
std::vector<Polyline3> ridges_and_valleys(const SmoothSurface& surface, const SmoothLineParams& params);

}  // namespace inkbench
