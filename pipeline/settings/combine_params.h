// SPDX-License-Identifier: MIT
// How the two edge terms become lines (3.4.4).
#pragma once

#include "pipeline/params/description.h"

namespace inkbench {

struct CombineParams {
  float k_depth = 0.003F;
  float k_normal = 0.0125F;
  float threshold = 0.75F;
  bool use_depth = true;
  bool use_normal = true;

  static const Description& description();
};

}  // namespace inkbench
