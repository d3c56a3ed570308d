// SPDX-License-Identifier: MIT
// What lies between neighbouring pixels: the angle between their surfaces and the gap between their planes,
// before any limit. In: the triangles' planes. Out: both for the neighbours to the right and above.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/gl/texture.h"
#include "pipeline/passes/gbuffer/lens_block.h"

namespace inkbench {

class PairsPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit PairsPass(const GeneratedSources& generated);
  /// Out: rgba16f as shaders/lib/pair_map.glsl says; all 0 where nothing is to be measured.
  Texture run(bool measures, const LensBlock& lens, const ImageWindow& window, const Texture& planes) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
