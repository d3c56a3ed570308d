// SPDX-License-Identifier: MIT
// Where the drawn window lies in the image, for shaders that include lib/place.glsl. In: the window. Out:
// their uniform block.
#pragma once

#include "pipeline/flow/image_window.h"
#include "pipeline/gl/program.h"

namespace inkbench {

/// place_block of shaders/lib/place.glsl in std140.
struct PlaceBlock {
  glm::vec2 middle_px;  ///< The whole image's.
  glm::vec2 padding;
};

/// What a program that includes it lists among its blocks.
inline const UniformBlock kPlaceBlock{"place_block", sizeof(PlaceBlock)};

inline Buffer place_buffer(const ImageWindow& window) {
  const PlaceBlock block{window.middle_px(), {}};
  return {"place block", bytes_of(std::span(&block, 1))};
}

}  // namespace inkbench
