// SPDX-License-Identifier: MIT
// How near and how far the visible surfaces are, along the view axis.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/gbuffer/gbuffer.h"

namespace inkbench {

class VisibleRangePass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit VisibleRangePass(const GeneratedSources& generated);
  /// Out: rg32f, 1 x 1: the nearest and the farthest distance in world units; 1e30 and 0 where nothing is
  /// visible. A part of an image has the whole's.
  Texture run(float far, const ImageWindow& window, const GBuffer& gbuffer) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
