// SPDX-License-Identifier: MIT
// Detection by Decaudin's ranges of gradients against their k; a change of k runs it alone.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/passes/gbuffer/lens_block.h"

namespace inkbench {

class DecaudinPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit DecaudinPass(const GeneratedSources& generated);
  /// In: Decaudin's gradients, the normal and depth maps and ids. Out: a detection (detection_pass.h); its
  /// strength is twice the square of range / k.
  Texture run(const DecaudinParams& params, float weak, const LensBlock& lens, const Texture& gradient,
              const Texture& normal_and_depth, const GBuffer& gbuffer) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
