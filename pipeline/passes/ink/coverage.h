// SPDX-License-Identifier: MIT
// How much of each pixel is ink: the share that its nearest line covers.
#pragma once

#include <cstdint>

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/passes/gbuffer/lens_block.h"

namespace inkbench {

/// coverage_block of shaders/lib/pieces.glsl in std140.
struct CoverageBlock {
  int samples;
  int padding;
  uint32_t within[2];  ///< Of no account where a flood has found the nearest line.
};
inline const UniformBlock kCoverageBlock{"coverage_block", sizeof(CoverageBlock)};
Buffer coverage_buffer(const CoverageBlock& block);

/// How many samples a side `line.antialias` asks for; 0: the exact share.
int drawn_samples(const Settings& settings);

class CoveragePass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit CoveragePass(const GeneratedSources& generated);
  /// In: each pixel's nearest line (flood.h); `samples` a side that are in or out, or 0 for the exact share.
  /// Out: rg8: coverage, 0 to 1; class / 255, 0 where there is no ink. Not over a surface that lies in front
  /// of the line's.
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
