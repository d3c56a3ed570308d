// SPDX-License-Identifier: MIT
// Detection by the angles and gaps between neighbouring pixels' planes, against their limits.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/gl/texture.h"

namespace inkbench {

class DihedralPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit DihedralPass(const GeneratedSources& generated);
  /// In: pairs (pairs.h). Out: a detection (detection_pass.h).
  Texture run(const DihedralParams& params, float weak, const Texture& pairs) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
