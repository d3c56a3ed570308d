// SPDX-License-Identifier: MIT
// The detected pixels that a line may go through: of those along a step in depth the nearer surface's alone.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/passes/gbuffer/lens_block.h"

namespace inkbench {

class CandidatesPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit CandidatesPass(const GeneratedSources& generated);
  /// In: a detection and its tiles, the share of the limit from which a pixel counts. Out: r8, 0 or 1.
  Texture run(float weak, const LensBlock& lens, const Texture& detection, const Texture& tiles,
              const GBuffer& gbuffer) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
