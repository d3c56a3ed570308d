// SPDX-License-Identifier: MIT
// Detection by Saito and Takahashi's operators on the visible depth: profiles by the first order, creases by
// the second.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/gl/texture.h"
#include "pipeline/settings/detector_params.h"

namespace inkbench {

class SaitoTakahashiPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit SaitoTakahashiPass(const GeneratedSources& generated);
  /// In: the visible depth (visible_depth.h). Out: a detection (detection_pass.h); a crease's strength is at
  /// most 2.
  Texture run(const SaitoTakahashiParams& params, float weak, const Texture& visible_depth) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
