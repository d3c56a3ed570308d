// SPDX-License-Identifier: MIT
// How lines are drawn over the shading (3.5).
#pragma once

#include <array>
#include <string_view>

#include "pipeline/params/description.h"

namespace inkbench {

/// `filter`: what `edges.method` finds. `strokes`: curves drawn by a stroke style.
enum class InkFrom { filter, strokes, both };
template <>
struct ChoiceNames<InkFrom> {
  static constexpr std::array<std::string_view, 3> names{"filter", "strokes", "both"};
};

/// What it is drawn over.
enum class InkOver { shading, paper };
template <>
struct ChoiceNames<InkOver> {
  static constexpr std::array<std::string_view, 2> names{"shading", "paper"};
};

struct InkParams {
  InkFrom from = InkFrom::filter;
  glm::vec3 colour{0.0F};
  InkOver over = InkOver::shading;
  glm::vec3 paper{1.0F};

  static const Description& description();
};

}  // namespace inkbench
