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
      "quantise", 3, {shows(BufferName::normal), shows(BufferName::depth)}, value_of<GBufferPass>(),
      part<&Settings::image, &ImageParams::precision>(), group<&Settings::camera>());
  return kKind;
}

QuantisePass::QuantisePass(const GeneratedSources& generated)
    : program_("full_screen.vert", "quantise.frag",
               {.samplers = {"normal_and_depth_map"}, .uniform_blocks = {kStoredBlock}}, generated) {}

bool QuantisePass::hands_on(const Settings& settings) {
  return settings.image.precision == Precision::float32;
}

Texture QuantisePass::run(const GBuffer& gbuffer, Precision precision, const CameraParams& camera) const {
  const Texture& exact = gbuffer.normal_and_depth;
  const TextureFormat format = precision == Precision::unorm8 ? TextureFormat::rgba8 : TextureFormat::rgba32f;
  Texture result("stored normal and depth", format, exact.width_px(), exact.height_px());
  const Buffer stored = stored_buffer(camera, precision);
  const RenderTarget target({&result}, nullptr);
  program_.use();
  bind_uniform_blocks({&stored});
  bind_textures({&exact});
  draw_full_screen();
  return result;
}

}  // namespace inkbench
