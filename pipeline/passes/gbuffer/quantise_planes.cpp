// SPDX-License-Identifier: MIT
#include "pipeline/passes/gbuffer/quantise_planes.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/gl/framebuffer.h"
#include "pipeline/passes/gbuffer/place_block.h"
#include "pipeline/passes/gbuffer/stored_block.h"

namespace inkbench {

const PassKind& QuantisePlanesPass::kind() {
  static const PassKind kKind = describe_pass<QuantisePlanesPass>(
      "quantise_planes", 3, {}, value_of<GBufferPass>(), part<&Settings::image, &ImageParams::precision>(),
      group<&Settings::camera>(), LensInput{}, WindowInput{});
  return kKind;
}

QuantisePlanesPass::QuantisePlanesPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "quantise_planes.frag",
               {.samplers = {"surface_map"}, .uniform_blocks = {kLensBlock, kStoredBlock, kPlaceBlock}},
               generated) {}

bool QuantisePlanesPass::hands_on(const Settings& settings) {
  const Precision precision = settings.image.precision;
  return !needs_surface(settings) || precision == Precision::float32 || precision == Precision::unorm8;
}

Texture QuantisePlanesPass::run(const GBuffer& gbuffer, Precision precision, const CameraParams& camera,
                                const LensBlock& lens, const ImageWindow& window) const {
  Texture planes("stored planes", TextureFormat::rgba32f, window.width, window.height);
  const Buffer lens_uniforms = lens_buffer(lens), stored = stored_buffer(camera, precision),
               place = place_buffer(window);
  const RenderTarget target({&planes}, nullptr);
  program_.use();
  bind_uniform_blocks({&lens_uniforms, &stored, &place});
  bind_textures({&gbuffer.surface});
  draw_full_screen();
  return planes;
}

}  // namespace inkbench
