// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/pairs.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"

namespace inkbench {

const PassKind& PairsPass::kind() {
  static const PassKind kKind =
      describe_pass<PairsPass>("pairs", 4, {}, LensInput{}, value_of<GBufferPass>());
  return kKind;
}

PairsPass::PairsPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "pairs.frag",
               {.samplers = {"surface_map"}, .uniform_blocks = {kLensBlock}}, generated) {}

Texture PairsPass::run(const LensBlock& lens, const GBuffer& gbuffer) const {
  Texture pairs("pairs", TextureFormat::rgba16f, gbuffer.surface.width_px(), gbuffer.surface.height_px());
  const Buffer lens_uniforms = lens_buffer(lens);
  draw_over(pairs, program_, {&gbuffer.surface}, {&lens_uniforms});
  return pairs;
}

}  // namespace inkbench
