// SPDX-License-Identifier: MIT
// What rounds normals and depths, for shaders that include lib/stored.glsl. In: camera and precision. Out:
// their uniform block.
#pragma once

#include "pipeline/gl/program.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

/// stored_block of shaders/lib/stored.glsl in std140.
struct StoredBlock {
  float near;  ///< World units.
  float far;
  int is_orthographic;
  int format;  ///< Precision.
};

/// What a program that includes it lists among its blocks.
inline const UniformBlock kStoredBlock{"stored_block", sizeof(StoredBlock)};

inline Buffer stored_buffer(const CameraParams& camera, Precision precision) {
  const StoredBlock block{camera.near, camera.far, is_orthographic(camera) ? 1 : 0,
                          static_cast<int>(precision)};
  return {"stored block", bytes_of(std::span(&block, 1))};
}

}  // namespace inkbench
