// SPDX-License-Identifier: MIT
// How much of each pixel is ink: the share that its nearest line covers.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/passes/gbuffer/lens_block.h"

namespace inkbench {

class CoveragePass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit CoveragePass(const GeneratedSources& generated);
  /// In: each pixel's nearest line (flood.h). Out: rg32f: coverage, 0 to 1 (0 or 1 without antialiasing);
  /// class, 0 where there is no ink. Not over a surface that lies in front of the line's.
  Texture run(bool antialias, const LensBlock& lens, const Texture& nearest, const GBuffer& gbuffer) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
