// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/range.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/gl/framebuffer.h"
#include "pipeline/passes/edges/gradient.h"

namespace inkbench {

const PassKind& RangePass::kind() {
  static const PassKind kKind = describe_pass<RangePass>("range", 5, {}, value_of<GradientPass>());
  return kKind;
}

RangePass::RangePass(const GeneratedSources& generated)
    : program_("full_screen.vert", "range.frag", {.samplers = {"gradient_map"}}, generated) {}

Texture RangePass::run(const Texture& gradient) const {
  Texture range("range", TextureFormat::rg32f, gradient.width_px(), gradient.height_px());
  const RenderTarget target({&range}, nullptr);
  program_.use();
  bind_textures({&gradient});
  draw_full_screen();
  return range;
}

}  // namespace inkbench
