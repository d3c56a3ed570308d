// SPDX-License-Identifier: MIT
#include "pipeline/passes/gbuffer/lens_block.h"

namespace inkbench {

LensBlock lens_of(const CameraParams& camera, int height_px) {
  const auto size = static_cast<float>(pixel_size(camera, 1.0, height_px));
  return {camera.far, size, is_orthographic(camera) ? 1 : 0, 0};
}

Buffer lens_buffer(const LensBlock& lens) {
  return {"lens block", bytes_of(std::span(&lens, 1))};
}

}  // namespace inkbench
