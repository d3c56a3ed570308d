// SPDX-License-Identifier: MIT
// Gradients of the depth map and of each component of the normal map, as Decaudin's detector compares them.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"

namespace inkbench {

class DecaudinGradientPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit DecaudinGradientPass(const GeneratedSources& generated);
  /// In: the normal map, and the depth map in alpha. Out: rgba32f: the first-order operator (operators.h) on
  /// the normal map's x, y and z and on the depth map.
  Texture run(const Texture& normal_and_depth) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
