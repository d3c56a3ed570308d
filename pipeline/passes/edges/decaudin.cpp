// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/decaudin.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/decaudin_gradient.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/gbuffer/quantise.h"

namespace inkbench {

const PassKind& DecaudinPass::kind() {
  static const PassKind kKind = describe_pass<DecaudinPass>(
      "decaudin", 6, {}, group<&Settings::decaudin>(), part<&Settings::edges, &EdgesParams::weak>(),
      LensInput{}, value_of<DecaudinGradientPass>(), value_of<QuantisePass>(), value_of<GBufferPass>());
  return kKind;
}

DecaudinPass::DecaudinPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "decaudin.frag",
               {.samplers = {"gradient_map", "normal_and_depth_map", "object_id_map"},
                .uniform_blocks = {block_of(EdgesParams::description()),
                                   block_of(DecaudinParams::description()), kLensBlock}},
               generated) {}

Texture DecaudinPass::run(const DecaudinParams& params, float weak, const LensBlock& lens,
                          const Texture& gradient, const Texture& normal_and_depth,
                          const GBuffer& gbuffer) const {
  Texture detection = detection_target("decaudin", gradient);
  const Buffer edges = weak_block(weak), limits = block_buffer(params), lens_uniforms = lens_buffer(lens);
  draw_over(detection, program_, {&gradient, &normal_and_depth, &gbuffer.object_id},
            {&edges, &limits, &lens_uniforms});
  return detection;
}

}  // namespace inkbench
