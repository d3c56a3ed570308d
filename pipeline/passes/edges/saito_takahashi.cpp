// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/saito_takahashi.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/gbuffer/quantise.h"
#include "pipeline/passes/gbuffer/visible_depth.h"

namespace inkbench {

const PassKind& SaitoTakahashiPass::kind() {
  static const PassKind kKind = describe_pass<SaitoTakahashiPass>(
      "saito_takahashi", 6, {}, group<&Settings::saito_takahashi>(),
      part<&Settings::edges, &EdgesParams::weak>(), LensInput{}, value_of<VisibleDepthPass>(),
      value_of<QuantisePass>(), value_of<GBufferPass>());
  return kKind;
}

SaitoTakahashiPass::SaitoTakahashiPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "saito_takahashi.frag",
               {.samplers = {"visible_depth_map", "normal_and_depth_map", "object_id_map"},
                .uniform_blocks = {block_of(EdgesParams::description()),
                                   block_of(SaitoTakahashiParams::description()), kLensBlock}},
               generated) {}

Texture SaitoTakahashiPass::run(const SaitoTakahashiParams& params, float weak, const LensBlock& lens,
                                const Texture& visible_depth, const Texture& normal_and_depth,
                                const GBuffer& gbuffer) const {
  Texture detection = detection_target("saito_takahashi", visible_depth);
  const Buffer edges = weak_block(weak), limits = block_buffer(params), lens_uniforms = lens_buffer(lens);
  draw_over(detection, program_, {&visible_depth, &normal_and_depth, &gbuffer.object_id},
            {&edges, &limits, &lens_uniforms});
  return detection;
}

}  // namespace inkbench
