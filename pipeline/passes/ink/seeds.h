// SPDX-License-Identifier: MIT
// Placed lines with their widths, as seeds of the flood that looks for each pixel's nearest line.
#pragma once

#include <array>

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/passes/gbuffer/lens_block.h"

namespace inkbench {

/// All that the lines' widths depend on besides where they are.
struct WidthParams {
  LineParams line;
  std::array<float, kEdgeClasses> of_class{};  ///< Times `line.width`, from `EdgeClass::object` on.
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

/// Half the width in px of the widest line there can be. `visible`: as `VisibleRangePass` gives it; read only
/// for widths in world units, else null. 0 where nothing is visible.
float widest_half_px(const WidthParams& widths, const LensBlock& lens, int height_px, const Texture* visible);

class SeedsPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit SeedsPass(const GeneratedSources& generated);
  /// In: placed lines (placed_lines.h). Out: rgba32f: the line's point in pixels from the lower left corner,
  /// half its width in pixels, its class; all 0 where no line goes through the pixel.
  Texture run(const WidthParams& widths, const LensBlock& lens, const Texture& placed, const GBuffer& gbuffer,
              const Texture* visible) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
