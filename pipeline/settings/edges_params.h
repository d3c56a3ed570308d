// SPDX-License-Identifier: MIT
// Which detector finds the lines, and what becomes of what it finds before it is drawn.
#pragma once

#include <array>
#include <string_view>

#include "pipeline/params/description.h"

namespace inkbench {

/// In the order of `edge_detectors()` (pipeline/passes/edges/edge_detector.h).
enum class EdgeMethod { paper, decaudin, saito_takahashi, mitchell, laplacian, dihedral };
template <>
struct ChoiceNames<EdgeMethod> {
  static constexpr std::array<std::string_view, 6> names{"paper",    "decaudin",  "saito_takahashi",
                                                         "mitchell", "laplacian", "dihedral"};
};

struct EdgesParams {
  EdgeMethod method = EdgeMethod::paper;
  float weak = 1.0F;
  float min_length = 0.0F;

  static const Description& description();
};

}  // namespace inkbench
