// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/paper_strength.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/edges/range.h"

namespace inkbench {

const PassKind& PaperStrengthPass::kind() {
  static const PassKind kKind = describe_pass<PaperStrengthPass>(
      "paper_strength", 6, {}, group<&Settings::combine>(), value_of<RangePass>());
  return kKind;
}

PaperStrengthPass::PaperStrengthPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "paper_strength.frag",
               {.samplers = {"range_map"}, .uniform_blocks = {block_of(CombineParams::description())}},
               generated) {}

Texture PaperStrengthPass::run(const CombineParams& params, const Texture& range) const {
  Texture detection = detection_target("paper's strength", range);
  const Buffer combine = block_buffer(params);
  draw_over(detection, program_, {&range}, {&combine});
  return detection;
}

}  // namespace inkbench
