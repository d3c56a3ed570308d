// SPDX-License-Identifier: MIT
// Detection by the discontinuities of Mitchell, Brennan and Card: normals, depth, object ids, materials'
// colours. Their shadow edges need a map of shadows, which there is not yet.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/gbuffer/gbuffer.h"

namespace inkbench {

class MitchellPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit MitchellPass(const GeneratedSources& generated);
  /// In: the normal and depth maps, ids, materials (albedo.h). Out: a detection (detection_pass.h);
  /// `material` where only the colours differ enough.
  Texture run(const MitchellParams& params, float weak, const Texture& normal_and_depth,
              const GBuffer& gbuffer, const Texture& albedo) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
