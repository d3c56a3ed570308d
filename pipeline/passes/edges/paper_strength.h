// SPDX-License-Identifier: MIT
// The paper's sum of terms as a detection, for those who look at strengths and classes; its lines do not need
// it.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/gl/texture.h"
#include "pipeline/settings/combine_params.h"

namespace inkbench {

class PaperStrengthPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit PaperStrengthPass(const GeneratedSources& generated);
  /// In: ranges of both gradients. Out: a detection (detection_pass.h): the sum of the terms over the
  /// threshold.
  Texture run(const CombineParams& params, const Texture& range) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
