// SPDX-License-Identifier: MIT
#include "pipeline/passes/placing/candidates.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/edges/found_edges.h"

namespace inkbench {

const PassKind& CandidatesPass::kind() {
  static const PassKind kKind =
      describe_pass<CandidatesPass>("candidates", 3, {}, part<&Settings::edges, &EdgesParams::weak>(),
                                    LensInput{}, value_of<FoundEdges>(), value_of<GBufferPass>());
  return kKind;
}

CandidatesPass::CandidatesPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "candidates.frag",
               {.samplers = {"detection_map", "normal_and_depth_map"},
                .uniform_blocks = {block_of(EdgesParams::description()), kLensBlock}},
               generated) {}

Texture CandidatesPass::run(float weak, const LensBlock& lens, const Texture& detection,
                            const GBuffer& gbuffer) const {
  Texture candidates("candidates", TextureFormat::r8, detection.width_px(), detection.height_px());
  const Buffer edges = weak_block(weak), lens_uniforms = lens_buffer(lens);
  draw_over(candidates, program_, {&detection, &gbuffer.normal_and_depth}, {&edges, &lens_uniforms});
  return candidates;
}

}  // namespace inkbench
