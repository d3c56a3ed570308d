// SPDX-License-Identifier: MIT
// How wide a stroke is along its path. In: a path as it is drawn, the style, what widths follow. Out: a
// radius for each point.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "pipeline/image/image.h"
#include "pipeline/settings/stroke_params.h"
#include "pipeline/strokes/stroke_path.h"

namespace inkbench {

/// What of the view widths follow.
struct StrokeSurroundings {
  int height_px = 0;              ///< Of the image: widths in percent are of it.
  glm::vec2 visible{0.0F, 0.0F};  ///< Nearest and farthest visible distance, world units.
  /// Of a pixel: world units at distance 1; orthographic: world units anywhere.
  float pixel_size = 0.0F;
  bool is_orthographic = false;
  const Image* luminance = nullptr;  ///< Of the shaded picture, H x W x 1, 0 black to 1 white; null: no one
                                     ///< looks at it.
  const Image* object_id = nullptr;  ///< H x W x 1: whose shading it is; null: not known.
};

/// The style's profile, read once.
using WidthProfile = std::vector<ProfilePoint>;

/// Half the width in px at each point of the path: `stroke.width` by class (blended where it changes), depth,
/// curvature, light, profile, and tapers.
std::vector<float> stroke_radii(const StrokePath& path, const StrokeParams& params,
                                const StrokeClasses& classes, const WidthProfile& profile,
                                const StrokeSurroundings& around);

/// The share of the width that the profile gives at a place from 0 to 1.
float share_of(const WidthProfile& profile, float along);

/// How bright a colour looks, 0 to 1, of its linear red, green and blue (Rec. 709).
float luminance_of(float red, float green, float blue);

}  // namespace inkbench
