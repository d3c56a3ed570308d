// SPDX-License-Identifier: MIT
// How a camera's pixels lie in the world, for shaders that include lib/lens.glsl. In: camera and image. Out:
// their uniform block.
#pragma once

#include "pipeline/flow/inputs.h"
#include "pipeline/gl/program.h"

namespace inkbench {

/// lens_block of shaders/lib/lens.glsl in std140.
struct LensBlock {
  float far;         ///< World units.
  float pixel_size;  ///< Of a pixel: world units at distance 1; orthographic: world units anywhere.
  int is_orthographic;
  int padding;
};

LensBlock lens_of(const CameraParams& camera, int height_px);

/// What a program that includes it lists among its blocks.
inline const UniformBlock kLensBlock{"lens_block", sizeof(LensBlock)};

/// The lens as an input. Run with: const LensBlock&.
struct LensInput {
  LensInput bind(Flow&) const { return *this; }
  static std::vector<PassInput> told() { return {{CameraParams::description().group}}; }
  LensBlock get(const FrameState& frame) const {
    return lens_of(frame.settings.camera, frame.settings.image.height);
  }
  void fold(KeyBuilder& key, const FrameState& frame) const {
    const LensBlock lens = get(frame);
    key.add_bytes({reinterpret_cast<const uint8_t*>(&lens), sizeof lens});
  }
};

Buffer lens_buffer(const LensBlock& lens);

}  // namespace inkbench
