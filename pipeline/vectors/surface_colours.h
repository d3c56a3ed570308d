// SPDX-License-Identifier: MIT
// What colour the surface has that a stroke lies on or beside: what shaders/stroke_colours_of_surface.frag
// finds for a pixel. In: a view's colours and what stands where. Out: a colour.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "pipeline/image/image.h"

namespace inkbench {

/// All H x W of one size.
struct SurfaceColours {
  Image colours;     ///< 3 channels or more, 0 to 1.
  Image depth;       ///< The last channel is the distance, in any unit.
  Image object_ids;  ///< 1 channel.
  float reach_px = 4.0F;

  /// The mean colour of the object that is nearest to the eye among some places within the reach.
  glm::vec3 at(const glm::vec2& place) const;
};

}  // namespace inkbench
