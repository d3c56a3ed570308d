// SPDX-License-Identifier: MIT
// Gradients of the depth and normal maps by the paper's improved Sobel filter (3.4.3).
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/settings/image_params.h"

namespace inkbench {

class GradientPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit GradientPass(const GeneratedSources& generated);
  /// In: the normal map, and the depth map in alpha. Out: two channels: g of the depth map, mean of g over
  /// the normal map's x, y and z. rg32f, or rg8 for eight bits.
  Texture run(const Texture& normal_and_depth, Precision precision) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
