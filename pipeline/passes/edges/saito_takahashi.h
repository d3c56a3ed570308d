// SPDX-License-Identifier: MIT
// Detection by Saito and Takahashi's operators on the visible depth: profiles by the first order, creases by
// the second.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/passes/gbuffer/lens_block.h"

namespace inkbench {

class SaitoTakahashiPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit SaitoTakahashiPass(const GeneratedSources& generated);
  /// In: the visible depth (visible_depth.h), the normal and depth maps and ids. Out: a detection
  /// (detection_pass.h); a crease's strength is at most 2.
  Texture run(const SaitoTakahashiParams& params, float weak, const LensBlock& lens,
              const Texture& visible_depth, const Texture& normal_and_depth, const GBuffer& gbuffer) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
