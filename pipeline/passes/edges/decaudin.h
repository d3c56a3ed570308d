// SPDX-License-Identifier: MIT
// Detection by Decaudin's ranges of gradients against their k; a change of k runs it alone.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/gl/texture.h"
#include "pipeline/settings/detector_params.h"

namespace inkbench {

class DecaudinPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit DecaudinPass(const GeneratedSources& generated);
  /// In: Decaudin's gradients. Out: a detection (detection_pass.h); its strength is twice the square of range
  /// / k.
  Texture run(const DecaudinParams& params, float weak, const Texture& gradient) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
