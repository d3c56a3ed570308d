// SPDX-License-Identifier: MIT
// What a detected pixel is of, by the surfaces around it, worked out beside the GPU. In: raw buffers and the
// lens. Out: a class. shaders/edge_class.frag and lib/lens.glsl are the same.
#pragma once

#include "pipeline/image/image.h"
#include "pipeline/passes/gbuffer/lens_block.h"
#include "pipeline/settings/line_params.h"

namespace inkbench {

/// Raw buffers of one image, all of one size.
struct SurfaceMaps {
  const Image* depth = nullptr;      ///< H x W x 1.
  const Image* normal = nullptr;     ///< H x W x 3.
  const Image* object_id = nullptr;  ///< H x W x 1.
};

/// The depth map holds 1 where no model is.
inline bool is_background(double depth) {
  return depth >= 1.0;
}

/// What is affine in the image on planes: 1 / distance (0 where no model is); orthographic: the distance.
double affine_depth(const LensBlock& lens, double depth);

/// A second difference of `affine_depth` at a pixel that has `here`, in pixels' sizes in the world.
double in_pixel_sizes(const LensBlock& lens, double second_difference, double here);

/// The class of the pixel (x, y), of a detector that looks `reach` pixels far. Depth and ids are needed.
EdgeClass edge_class(const SurfaceMaps& maps, const LensBlock& lens, int x, int y, int reach);

/// "silhouette"; empty for none.
std::string class_name(EdgeClass edge_class);

}  // namespace inkbench
