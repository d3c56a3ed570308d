// SPDX-License-Identifier: MIT
// The normal and depth maps as a smaller G-buffer stores them, for `image.precision` other than float.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/passes/gbuffer/stored_block.h"

namespace inkbench {

class QuantisePass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit QuantisePass(const GeneratedSources& generated);
  /// Whether float buffers are wanted: then the G-buffer's own texture is handed on.
  static bool hands_on(const Settings& settings);
  static const Texture& handed(const GBuffer& gbuffer) { return gbuffer.normal_and_depth; }
  /// In: normal and depth as the G-buffer has them. Out: the same, rgba8 for eight bits, else rounded floats.
  Texture run(const GBuffer& gbuffer, Precision precision, const CameraParams& camera) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
