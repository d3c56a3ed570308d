// SPDX-License-Identifier: MIT
// Which tiles of the image have a detected pixel: what looks at those alone leaves the others out.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/gl/texture.h"

namespace inkbench {

class EdgeTilesPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit EdgeTilesPass(const GeneratedSources& generated);
  /// In: the share of the limit from which a pixel counts, a detection (detection_pass.h). Out: r8, a texel
  /// for 8 x 8 pixels: 1 where one of them counts or has a class, else 0.
  Texture run(float weak, const Texture& detection) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
