// SPDX-License-Identifier: MIT
// What lies between neighbouring pixels: the angle between their surfaces and the gap between their planes,
// before any limit. In: the G-buffer's planes. Out: both for the neighbours to the right and above.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/passes/gbuffer/lens_block.h"

namespace inkbench {

/// The gap between two objects, or an object and the background; no other one is as large.
inline constexpr float kObjectGap = 60000.0F, kLargestGap = 50000.0F;

class PairsPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit PairsPass(const GeneratedSources& generated);
  /// Out: rgba16f. Red and green: the angle to the pixel on the right and to the one above, in degrees; blue
  /// and alpha: the gap, in pixels' sizes. Below 0 where the line that it may be is the other pixel's.
  Texture run(BendNormals normals, const LensBlock& lens, const Texture& normal_and_depth,
              const GBuffer& gbuffer) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
