// SPDX-License-Identifier: MIT
// The paper's sum of terms as a detection, for those who look at strengths and classes; its lines do not need
// it.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/passes/gbuffer/lens_block.h"

namespace inkbench {

class PaperStrengthPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit PaperStrengthPass(const GeneratedSources& generated);
  /// In: ranges of both gradients. Out: a detection (detection_pass.h): the sum of the terms over the
  /// threshold.
  Texture run(const CombineParams& params, const LensBlock& lens, const Texture& range,
              const Texture& normal_and_depth, const GBuffer& gbuffer) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
