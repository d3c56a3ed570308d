// SPDX-License-Identifier: MIT
#include "pipeline/passes/placing/dihedral_place.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/edges/pairs.h"

namespace inkbench {

const PassKind& DihedralPlacePass::kind() {
  static const PassKind kKind = describe_pass<DihedralPlacePass>(
      "dihedral_place", 3, {}, group<&Settings::dihedral>(), part<&Settings::edges, &EdgesParams::weak>(),
      LensInput{}, value_of<PairsPass>(), value_of<GBufferPass>());
  return kKind;
}

DihedralPlacePass::DihedralPlacePass(const GeneratedSources& generated)
    : program_("full_screen.vert", "dihedral_place.frag",
               {.samplers = {"pair_map", "surface_map"},
                .uniform_blocks = {block_of(EdgesParams::description()),
                                   block_of(DihedralParams::description()), kLensBlock}},
               generated) {}

Texture DihedralPlacePass::run(const DihedralParams& params, float weak, const LensBlock& lens,
                               const Texture& pairs, const GBuffer& gbuffer) const {
  Texture placed("placed lines", TextureFormat::rgba32f, pairs.width_px(), pairs.height_px());
  const Buffer edges = weak_block(weak), limits = block_buffer(params), lens_uniforms = lens_buffer(lens);
  draw_over(placed, program_, {&pairs, &gbuffer.surface}, {&edges, &limits, &lens_uniforms});
  return placed;
}

}  // namespace inkbench
