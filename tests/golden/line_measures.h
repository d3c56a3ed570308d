// SPDX-License-Identifier: MIT
// Simple measures of a drawing's ink, for holding the figures to what is said of them. Masks are 1-channel
// pictures, not zero where something is; the published measures are those of studies/.
#pragma once

#include <glm/vec2.hpp>

#include "pipeline/image/image.h"

namespace inkbench {

using Mask = Picture;  ///< H x W x 1.

/// Where the combined edges are not zero.
Mask ink_of(const Image& combined_edges);

/// Where `object_id` is `id`.
Mask pixels_of_object(const Image& object_id, float id);

/// Pixels of the mask that have one of their four neighbours outside it.
Mask border_of(const Mask& mask);

size_t count(const Mask& mask);

/// Pixels in both, and pixels in the first but not in the second.
Mask both(const Mask& a, const Mask& b);
Mask without(const Mask& a, const Mask& b);

/// Chebyshev distance in px from each pixel of the mask to the nearest pixel outside it (1 at its border, the
/// picture's edge is no border), 0 outside.
ImageOf<int> depth_inside(const Mask& mask);

/// Pixels of `inside` at least that deep.
Mask at_least_deep(const ImageOf<int>& depth, int px);

/// All pixels that can be reached from `start` over pixels of `free`, by 4 or 8 neighbours.
Mask flood(const Mask& start, const Mask& free, int neighbours);

/// Number of 8-connected pieces.
int pieces(const Mask& mask);

/// Share of the places along the segment, a pixel apart, that have ink in their 3 x 3 pixels.
double inked_share(const Mask& ink, glm::vec2 from_px, glm::vec2 to_px);

struct Thickness {
  double mean_px = 0.0;
  double variation = 0.0;  ///< Standard deviation / mean.
};

/// Of the ink at those of the places that are inked: the shortest of its runs through the pixel in four
/// directions.
Thickness thickness_at(const Mask& ink, const Mask& places);

}  // namespace inkbench
