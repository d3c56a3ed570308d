// SPDX-License-Identifier: MIT
// The coverage of narrow lines straight from where they are placed, in one pass: without a flood.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/passes/ink/line_widths.h"

namespace inkbench {

/// Are all lines so narrow, 4 px, that this is the cheaper way? Not known before drawing of widths in world
/// units.
bool lines_are_narrow(const Settings& settings);

class NarrowCoveragePass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit NarrowCoveragePass(const GeneratedSources& generated);
  /// In: placed lines and which pixels have one (line_bits.h). Out: as `CoveragePass`.
  Texture run(int samples, const WidthParams& widths, const LensBlock& lens, const Texture& placed,
              const Texture& bits, const GBuffer& gbuffer) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

/// The coverage of placed lines, by the way that is cheaper.
struct LineCoverage {
  using Value = Texture;
  static const PassKind& kind();
  static size_t chosen(const Settings& settings) { return lines_are_narrow(settings) ? 0 : 1; }
};

}  // namespace inkbench
