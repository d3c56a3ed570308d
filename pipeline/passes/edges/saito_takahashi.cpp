// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/saito_takahashi.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/gbuffer/visible_depth.h"

namespace inkbench {

const PassKind& SaitoTakahashiPass::kind() {
  static const PassKind kKind = describe_pass<SaitoTakahashiPass>(
      "saito_takahashi", 6, {}, group<&Settings::saito_takahashi>(),
      part<&Settings::edges, &EdgesParams::weak>(), value_of<VisibleDepthPass>());
  return kKind;
}

SaitoTakahashiPass::SaitoTakahashiPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "saito_takahashi.frag",
               {.samplers = {"visible_depth_map"},
                .uniform_blocks = {block_of(EdgesParams::description()),
                                   block_of(SaitoTakahashiParams::description())}},
               generated) {}

Texture SaitoTakahashiPass::run(const SaitoTakahashiParams& params, float weak,
                                const Texture& visible_depth) const {
  Texture detection = detection_target("saito_takahashi", visible_depth);
  const Buffer edges = weak_block(weak), limits = block_buffer(params);
  draw_over(detection, program_, {&visible_depth}, {&edges, &limits});
  return detection;
}

}  // namespace inkbench
