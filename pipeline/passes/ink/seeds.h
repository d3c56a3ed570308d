// SPDX-License-Identifier: MIT
// Placed lines with their widths, as seeds of the flood that looks for each pixel's nearest line.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/passes/ink/line_widths.h"

namespace inkbench {

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
