// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/dihedral.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/edges/shaded_pairs.h"

namespace inkbench {

const PassKind& DihedralPass::kind() {
  static const PassKind kKind =
      describe_pass<DihedralPass>("dihedral", 3, {}, group<&Settings::dihedral>(),
                                  part<&Settings::edges, &EdgesParams::weak>(), value_of<ShadedPairsPass>());
  return kKind;
}

DihedralPass::DihedralPass(const GeneratedSources& generated)
    : program_(
          "full_screen.vert", "dihedral.frag",
          {.samplers = {"pair_map"},
           .uniform_blocks = {block_of(EdgesParams::description()), block_of(DihedralParams::description())}},
          generated) {}

Texture DihedralPass::run(const DihedralParams& params, float weak, const Texture& pairs) const {
  Texture detection = detection_target("dihedral", pairs);
  const Buffer edges = weak_block(weak), limits = block_buffer(params);
  draw_over(detection, program_, {&pairs}, {&edges, &limits});
  return detection;
}

}  // namespace inkbench
