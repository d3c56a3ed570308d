// SPDX-License-Identifier: MIT
// Silhouettes of the smooth surface that a mesh stands for: where the normals between its points turn away
// from the eye. In: the surface, the eye. Out: lines through faces, hidden parts included. Source: Hertzmann,
// "Introduction to 3D non-photorealistic rendering", 1999, section 3.
#pragma once

#include <vector>

#include "pipeline/curves/silhouette_tree.h"
#include "pipeline/lines/lines.h"
#include "pipeline/lines/smooth_surface.h"

namespace inkbench {

class SmoothSilhouettes {
 public:
  SmoothSilhouettes() = default;
  explicit SmoothSilhouettes(const SmoothSurface& surface);
  /// Zeros of dot(normal, eye - point), linear along edges. A value of 0 counts as facing the eye.
  std::vector<SurfaceLine> find(const SmoothSurface& surface, const Viewpoint& eye) const;

 private:
  SilhouetteTree tree_;
};

}  // namespace inkbench
