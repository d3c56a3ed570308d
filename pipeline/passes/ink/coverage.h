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
  /// In: each pixel's nearest line (flood.h); `samples` a side that are in or out, or 0 for the exact share.
  /// Out: rg32f: coverage, 0 to 1; class, 0 where there is no ink. Not over a surface that lies in front of
  /// the line's.
  Texture run(int samples, const LensBlock& lens, const Texture& nearest, const GBuffer& gbuffer) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

/// The same lines without antialiasing, and rasterised at 8 x 8: what antialiasing is measured against.
struct AliasedCoverage {
  using Value = Texture;
  using Pass = CoveragePass;
  static const PassKind& kind();
};
struct SampledCoverage {
  using Value = Texture;
  using Pass = CoveragePass;
  static const PassKind& kind();
};

}  // namespace inkbench
