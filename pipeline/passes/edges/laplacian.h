// SPDX-License-Identifier: MIT
// Detection by the Laplacian of 1/z: planes at any slope have none, a step or a bend has one in units of
// slope.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/gl/texture.h"
#include "pipeline/passes/gbuffer/lens_block.h"

namespace inkbench {

class LaplacianPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit LaplacianPass(const GeneratedSources& generated);
  /// In: the normal and depth maps. Out: a detection (detection_pass.h).
  Texture run(const LaplacianParams& params, float weak, const LensBlock& lens,
              const Texture& normal_and_depth) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
