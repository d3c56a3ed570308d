// SPDX-License-Identifier: MIT
// The edge passes and the ink in double precision, written from the paper's equations (3.4.3 to 3.5), not
// from the shaders. In: maps. Out: what each pass should give; GL results are compared with it.
#pragma once

#include "pipeline/image/image.h"
#include "pipeline/settings/combine_params.h"
#include "pipeline/settings/ink_params.h"

namespace inkbench::reference {

using Map = ImageOf<double>;  ///< H x W x C, row 0 on top.

Map to_map(const Image& image);
Image to_image(const Map& map);

/// g of 3.4.3 in each channel, then the mean over the channels: H x W x 1. The paper does not say what lies
/// outside the image; we repeat its border.
Map gradient(const Map& map);

/// gmax - gmin over the 3 x 3 region (3.4.4), the part of it inside the image: H x W x 1.
Map range(const Map& gradient);

/// p_depth + p_normal before the threshold (3.4.4).
Map term_sum(const Map& depth_range, const Map& normal_range, const CombineParams& params);

/// 0 where the sum is below the threshold, else the sum, at most 1 as a framebuffer stores it.
Map combine(const Map& sum, const CombineParams& params);

/// The ink's colour where the edges are not 0, else the shading (3.5): H x W x 3.
Map ink(const Map& shaded, const Map& edges, const InkParams& params);

}  // namespace inkbench::reference
