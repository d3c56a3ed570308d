// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/pairs.h"

#include <array>

#include "pipeline/flow/describe_pass.h"
#include "pipeline/gl/framebuffer.h"
#include "pipeline/passes/edges/detection_pass.h"

namespace inkbench {
namespace {

/// place_block of shaders/pairs.frag in std140.
struct PlaceBlock {
  glm::vec2 middle_px;
  glm::vec2 padding;
};

}  // namespace

const PassKind& PairsPass::kind() {
  static const PassKind kKind =
      describe_pass<PairsPass>("pairs", 4, {}, derived<needs_surface>(EdgesParams::description), LensInput{},
                               WindowInput{}, value_of<GBufferPass>());
  return kKind;
}

PairsPass::PairsPass(const GeneratedSources& generated)
    : program_(
          "full_screen.vert", "pairs.frag",
          {.samplers = {"surface_map"}, .uniform_blocks = {kLensBlock, {"place_block", sizeof(PlaceBlock)}}},
          generated) {}

Texture PairsPass::run(bool measures, const LensBlock& lens, const ImageWindow& window,
                       const GBuffer& gbuffer) const {
  const Texture& like = gbuffer.object_id;
  Texture pairs("pairs", TextureFormat::rgba16f, like.width_px(), like.height_px());
  if (!measures) {  // the G-buffer may hold no planes
    const RenderTarget target({&pairs}, nullptr);
    constexpr std::array kNone{0.0F, 0.0F, 0.0F, 0.0F};
    glClearBufferfv(GL_COLOR, 0, kNone.data());
    return pairs;
  }
  const Buffer lens_uniforms = lens_buffer(lens);
  const PlaceBlock place{window.middle_px(), {}};
  const Buffer place_uniforms("place block", bytes_of(std::span(&place, 1)));
  draw_over(pairs, program_, {&gbuffer.surface}, {&lens_uniforms, &place_uniforms});
  return pairs;
}

}  // namespace inkbench
