// SPDX-License-Identifier: MIT
// What all passes share: the size of the image and the precision of the framebuffers between passes.
#pragma once

#include <array>
#include <string_view>

#include "pipeline/params/description.h"

namespace inkbench {

/// Precision of the normal, depth, edge and combined buffers: 32-bit float, or eight bits as in an ordinary
/// framebuffer.
enum class Precision { float32, unorm8 };
template <>
struct ChoiceNames<Precision> {
  static constexpr std::array<std::string_view, 2> names{"float", "unorm8"};
};

struct ImageParams {
  int width = 512;
  int height = 512;
  Precision precision = Precision::float32;
  int supersample = 1;

  static const Description& description();
};

}  // namespace inkbench
