// SPDX-License-Identifier: MIT
// Combined edges: both terms, their sum against the threshold (3.4.4).
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/settings/combine_params.h"
#include "pipeline/settings/image_params.h"

namespace inkbench {

class CombinePass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit CombinePass(const GeneratedSources& generated);
  /// In: ranges of the depth and normal gradients. Out: r32f or r8, 0 where there is no line.
  Texture run(const CombineParams& params, const Texture& range, Precision precision) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
