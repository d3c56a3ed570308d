// SPDX-License-Identifier: MIT
#include "pipeline/passes/ink/seeds.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/gbuffer/visible_range.h"
#include "pipeline/passes/placing/connect.h"

namespace inkbench {

const PassKind& SeedsPass::kind() {
  static const PassKind kKind =
      describe_pass<SeedsPass>("seeds", 2, {}, WidthInput{}, LensInput{}, value_of<ConnectPass>(),
                               value_of<GBufferPass>(), value_when<VisibleRangePass, widths_need_range>());
  return kKind;
}

SeedsPass::SeedsPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "seeds.frag",
               {.samplers = {"placed_map", "normal_and_depth_map", "visible_map"},
                .uniform_blocks = {block_of(LineParams::description()), kLensBlock, kWidthsBlock}},
               generated) {}

Texture SeedsPass::run(const WidthParams& widths, const LensBlock& lens, const Texture& placed,
                       const GBuffer& gbuffer, const Texture* visible) const {
  Texture seeds("seeds", TextureFormat::rgba32f, placed.width_px(), placed.height_px());
  const Buffer line = block_buffer(widths.line), lens_uniforms = lens_buffer(lens);
  const Buffer factors = widths_buffer(widths, visible != nullptr);
  const Texture& range = visible != nullptr ? *visible : placed;  // not looked at
  draw_over(seeds, program_, {&placed, &gbuffer.normal_and_depth, &range}, {&line, &lens_uniforms, &factors});
  return seeds;
}

}  // namespace inkbench
