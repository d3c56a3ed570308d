// SPDX-License-Identifier: MIT
#include "pipeline/passes/placing/candidates.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/edges/found_edges.h"
#include "pipeline/passes/placing/edge_tiles.h"
#include "pipeline/passes/placing/tiles.h"

namespace inkbench {

const PassKind& CandidatesPass::kind() {
  static const PassKind kKind = describe_pass<CandidatesPass>(
      "candidates", 3, {}, part<&Settings::edges, &EdgesParams::weak>(), LensInput{}, value_of<FoundEdges>(),
      value_of<EdgeTilesPass>(), value_of<GBufferPass>());
  return kKind;
}

CandidatesPass::CandidatesPass(const GeneratedSources& generated)
    : program_("tiles.vert", "candidates.frag",
               {.samplers = {"detection_map", "normal_and_depth_map", "tile_map"},
                .uniform_blocks = {block_of(EdgesParams::description()), kLensBlock, kSquaresBlock}},
               generated) {}

Texture CandidatesPass::run(float weak, const LensBlock& lens, const Texture& detection, const Texture& tiles,
                            const GBuffer& gbuffer) const {
  Texture candidates("candidates", TextureFormat::r8, detection.width_px(), detection.height_px());
  const Buffer edges = weak_block(weak), lens_uniforms = lens_buffer(lens);
  draw_over_tiles(candidates, program_, 0, {&detection, &gbuffer.normal_and_depth, &tiles},
                  {&edges, &lens_uniforms});
  return candidates;
}

}  // namespace inkbench
