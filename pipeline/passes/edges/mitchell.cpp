// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/mitchell.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/gbuffer/albedo.h"
#include "pipeline/passes/gbuffer/quantise.h"

namespace inkbench {

const PassKind& MitchellPass::kind() {
  static const PassKind kKind = describe_pass<MitchellPass>(
      "mitchell", 6, {}, group<&Settings::mitchell>(), part<&Settings::edges, &EdgesParams::weak>(),
      value_of<QuantisePass>(), value_of<GBufferPass>(), value_of<AlbedoPass>());
  return kKind;
}

MitchellPass::MitchellPass(const GeneratedSources& generated)
    : program_(
          "full_screen.vert", "mitchell.frag",
          {.samplers = {"normal_and_depth_map", "object_id_map", "albedo_map"},
           .uniform_blocks = {block_of(EdgesParams::description()), block_of(MitchellParams::description())}},
          generated) {}

Texture MitchellPass::run(const MitchellParams& params, float weak, const Texture& normal_and_depth,
                          const GBuffer& gbuffer, const Texture& albedo) const {
  Texture detection = detection_target("mitchell", normal_and_depth);
  const Buffer edges = weak_block(weak), limits = block_buffer(params);
  draw_over(detection, program_, {&normal_and_depth, &gbuffer.object_id, &albedo}, {&edges, &limits});
  return detection;
}

}  // namespace inkbench
