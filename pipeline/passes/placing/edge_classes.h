// SPDX-License-Identifier: MIT
// What the detected pixels are of: the buffer `edge_class`. Surfaces are looked at in the tiles alone that
// have such pixels, since that costs more than most detectors.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/passes/gbuffer/lens_block.h"

namespace inkbench {

class EdgeClassPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit EdgeClassPass(const GeneratedSources& generated);
  /// In: a detection (detection_pass.h) and its tiles, the normal and depth maps and ids. Out: r32f, H x W:
  /// the class (EdgeClass), 0 where nothing is detected.
  Texture run(const LensBlock& lens, const Texture& detection, const Texture& tiles,
              const Texture& normal_and_depth, const GBuffer& gbuffer) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
