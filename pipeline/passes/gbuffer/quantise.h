// SPDX-License-Identifier: MIT
// The normal and depth maps at eight bits, for `image.precision = "unorm8"`.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/gbuffer/gbuffer.h"

namespace inkbench {

class QuantisePass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit QuantisePass(const GeneratedSources& generated);
  /// Whether float buffers are wanted: then the G-buffer's own texture is handed on.
  static bool hands_on(const Settings& settings);
  static const Texture& handed(const GBuffer& gbuffer) { return gbuffer.normal_and_depth; }
  static PassInput handed_by() { return {ImageParams::description().group}; }
  /// In: normal and depth as the G-buffer has them. Out: the same as rgba8.
  Texture run(const GBuffer& gbuffer) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
