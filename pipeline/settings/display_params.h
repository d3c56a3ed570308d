// SPDX-License-Identifier: MIT
// How buffers are shown as pictures: gains that make small values visible. They change no buffer, only its
// picture.
#pragma once

#include "pipeline/params/description.h"

namespace inkbench {

struct DisplayParams {
  float depth_gain = 1.0F;
  float depth_edges_gain = 128.0F;
  float normal_edges_gain = 16.0F;
  float strength_gain = 0.5F;
  float pair_angles_gain = 0.01F;

  static const Description& description();
};

}  // namespace inkbench
