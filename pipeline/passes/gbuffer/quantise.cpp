// SPDX-License-Identifier: MIT
#include "pipeline/passes/gbuffer/quantise.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/gl/framebuffer.h"
#include "pipeline/passes/gbuffer/gbuffer.h"

namespace inkbench {
namespace {

constexpr BufferInfo kNormal{.name = "normal",
                             .help = "Surface directions in world space, as colours.",
                             .number_key = 1,
                             .channels = 3,
                             .shown_as = ShownAs::colour};
constexpr BufferInfo kDepth{.name = "depth",
                            .help = "Distance along the view as a share of the far plane's.",
                            .number_key = 2,
                            .first_channel = 3,
                            .gain = &DisplayParams::depth_gain};

}  // namespace

constinit const BufferName BufferName::normal{kNormal};
constinit const BufferName BufferName::depth{kDepth};

const PassKind& QuantisePass::kind() {
  static const PassKind kKind = describe_pass<QuantisePass>(
      "quantise", 3, {shows(BufferName::normal), shows(BufferName::depth)}, value_of<GBufferPass>());
  return kKind;
}

QuantisePass::QuantisePass(const GeneratedSources& generated)
    : program_("full_screen.vert", "quantise.frag", {.samplers = {"normal_and_depth_map"}}, generated) {}

bool QuantisePass::hands_on(const Settings& settings) {
  return settings.image.precision == Precision::float32;
}

Texture QuantisePass::run(const GBuffer& gbuffer) const {
  const Texture& normal_and_depth = gbuffer.normal_and_depth;
  Texture result("normal and depth, 8 bits", TextureFormat::rgba8, normal_and_depth.width_px(),
                 normal_and_depth.height_px());
  const RenderTarget target({&result}, nullptr);
  program_.use();
  bind_textures({&normal_and_depth});
  draw_full_screen();
  return result;
}

}  // namespace inkbench
