// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/pairs.h"

#include <array>

#include "pipeline/flow/describe_pass.h"
#include "pipeline/gl/framebuffer.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/gbuffer/place_block.h"
#include "pipeline/passes/gbuffer/quantise_planes.h"

namespace inkbench {

const PassKind& PairsPass::kind() {
  static const PassKind kKind =
      describe_pass<PairsPass>("pairs", 4, {}, derived<needs_surface>(EdgesParams::description), LensInput{},
                               WindowInput{}, value_of<QuantisePlanesPass>());
  return kKind;
}

PairsPass::PairsPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "pairs.frag",
               {.samplers = {"surface_map"}, .uniform_blocks = {kLensBlock, kPlaceBlock}}, generated) {}

Texture PairsPass::run(bool measures, const LensBlock& lens, const ImageWindow& window,
                       const Texture& planes) const {
  Texture pairs("pairs", TextureFormat::rgba16f, window.width, window.height);
  if (!measures) {  // there may be no planes
    const RenderTarget target({&pairs}, nullptr);
    constexpr std::array kNone{0.0F, 0.0F, 0.0F, 0.0F};
    glClearBufferfv(GL_COLOR, 0, kNone.data());
    return pairs;
  }
  const Buffer lens_uniforms = lens_buffer(lens);
  const Buffer place_uniforms = place_buffer(window);
  draw_over(pairs, program_, {&planes}, {&lens_uniforms, &place_uniforms});
  return pairs;
}

}  // namespace inkbench
