// SPDX-License-Identifier: MIT
// Which pixels have a line that is drawn, as bits: what draws narrow lines finds all lines near a pixel with
// a few looks (shaders/lib/line_bits.glsl).
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/ink/line_widths.h"

namespace inkbench {

class LineBitsPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit LineBitsPass(const GeneratedSources& generated);
  /// In: placed lines, H x W; the tiles that may have one (line_tiles.h). Out: rg32ui, a texel for 8 x 8
  /// pixels, a bit each: 1 where its line has a width.
  Texture run(const WidthParams& widths, const Texture& placed, const Texture& tiles) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
