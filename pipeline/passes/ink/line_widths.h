// SPDX-License-Identifier: MIT
// What placed lines' widths depend on, for the passes that draw them: parameters, their uniform blocks
// (shaders/lib/line_width.glsl), and how far a line can reach.
#pragma once

#include <array>

#include "pipeline/flow/inputs.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/gbuffer/lens_block.h"

namespace inkbench {

/// All that the lines' widths depend on besides where they are.
struct WidthParams {
  LineParams line;
  std::array<float, kEdgeClasses> of_class{};  ///< Times `line.width`, from `EdgeClass::object` on.
  int height_px = 0;                           ///< Of the whole image: widths in percent are of it.
};
WidthParams widths_of(const Settings& settings);
/// Do widths depend on the nearest and farthest distance, or does the most that they can be?
bool widths_need_range(const Settings& settings);

/// The widths as an input. Run with: const WidthParams&.
struct WidthInput {
  WidthInput bind(Flow&) const { return *this; }
  static std::vector<PassInput> told() { return {{LineParams::description().group}}; }
  WidthParams get(const FrameState& frame) const { return widths_of(frame.settings); }
  void fold(KeyBuilder& key, const FrameState& frame) const;
};

/// What of the widths says which lines are drawn at all: 0 for classes that are not. Run with: const
/// WidthParams&, of which only `of_class` is set.
struct ClassWidthInput {
  ClassWidthInput bind(Flow&) const { return *this; }
  static std::vector<PassInput> told() { return {{LineParams::description().group}}; }
  WidthParams get(const FrameState& frame) const;
  void fold(KeyBuilder& key, const FrameState& frame) const;
};

/// Half the width in px of the widest line there can be. `visible`: nearest and farthest distance; of no
/// account but for widths in world units. 0 where nothing is visible.
float widest_half_px(const WidthParams& widths, const LensBlock& lens, const glm::vec2& visible);
/// The same by what `VisibleRangePass` gives; null where widths are not in world units.
float widest_half_px(const WidthParams& widths, const LensBlock& lens, const Texture* visible);

/// widths_block in std140.
struct WidthsBlock {
  float of_class[8];
  float height_px;
  int need_distance;
  float padding[2];
};
inline const UniformBlock kWidthsBlock{"widths_block", sizeof(WidthsBlock)};
Buffer widths_buffer(const WidthParams& widths, bool need_distance);

}  // namespace inkbench
