// SPDX-License-Identifier: MIT
// Depth between the nearest and the farthest visible surface: it does not shift with the camera's planes, and
// is affine in the image on every plane (Saito and Takahashi 1990). The buffer `visible_depth`.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/gbuffer/lens_block.h"

namespace inkbench {

class VisibleDepthPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit VisibleDepthPass(const GeneratedSources& generated);
  /// In: the depth map, the visible range (visible_range.h): zn and zf. Out: r32f: (1/z - 1/zn) / (1/zf -
  /// 1/zn), 0 to 1; orthographic: (z - zn) / (zf - zn). Where no model is: as z = infinity, above 1;
  /// orthographic 2. Where zn and zf are one distance: 0, and 2 where no model is.
  Texture run(const LensBlock& lens, const Texture& normal_and_depth, const Texture& visible_range) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
