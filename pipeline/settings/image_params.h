// SPDX-License-Identifier: MIT
// What all passes share: the size of the image and the precision of the framebuffers between passes.
#pragma once

#include <array>
#include <string_view>

#include "pipeline/params/description.h"

namespace inkbench {

/// Precision of the buffers that lines are found in: 32-bit floats; eight bits as in an ordinary framebuffer,
/// edge and combined buffers too; normals and depths alone in 16-bit floats; or normals in 16-bit floats and
/// depths in 24 bits between the camera's planes, as games keep them.
enum class Precision { float32, unorm8, half, depth24 };
template <>
struct ChoiceNames<Precision> {
  static constexpr std::array<std::string_view, 4> names{"float", "unorm8", "half", "depth24"};
};

struct ImageParams {
  int width = 512;
  int height = 512;
  Precision precision = Precision::float32;
  int supersample = 1;

  static const Description& description();
};

}  // namespace inkbench
