// SPDX-License-Identifier: MIT
#include "pipeline/passes/gbuffer/lens_block.h"

#include <cmath>
#include <glm/trigonometric.hpp>

namespace inkbench {

LensBlock lens_of(const CameraParams& camera, int height_px) {
  const float pixel_size = 2.0F * std::tan(glm::radians(camera.fov) / 2.0F) / static_cast<float>(height_px);
  return {camera.far, pixel_size, 0, 0};
}

Buffer lens_buffer(const LensBlock& lens) {
  return {"lens block", bytes_of(std::span(&lens, 1))};
}

}  // namespace inkbench
