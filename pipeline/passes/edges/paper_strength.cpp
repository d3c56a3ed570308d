// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/paper_strength.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/edges/range.h"
#include "pipeline/passes/gbuffer/quantise.h"

namespace inkbench {

const PassKind& PaperStrengthPass::kind() {
  static const PassKind kKind = describe_pass<PaperStrengthPass>(
      "paper_strength", 6, {}, group<&Settings::combine>(), LensInput{}, value_of<RangePass>(),
      value_of<QuantisePass>(), value_of<GBufferPass>());
  return kKind;
}

PaperStrengthPass::PaperStrengthPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "paper_strength.frag",
               {.samplers = {"range_map", "normal_and_depth_map", "object_id_map"},
                .uniform_blocks = {block_of(CombineParams::description()), kLensBlock}},
               generated) {}

Texture PaperStrengthPass::run(const CombineParams& params, const LensBlock& lens, const Texture& range,
                               const Texture& normal_and_depth, const GBuffer& gbuffer) const {
  Texture detection = detection_target("paper's strength", range);
  const Buffer combine = block_buffer(params), lens_uniforms = lens_buffer(lens);
  draw_over(detection, program_, {&range, &normal_and_depth, &gbuffer.object_id}, {&combine, &lens_uniforms});
  return detection;
}

}  // namespace inkbench
