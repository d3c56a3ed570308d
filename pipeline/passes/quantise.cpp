#include "pipeline/passes/quantise.h"

#include "pipeline/gl/framebuffer.h"

namespace inkbench {

QuantisePass::QuantisePass(const GeneratedSources& generated)
    : program_("full_screen.vert", "quantise.frag", {.samplers = {"normal_map", "depth_map"}}, generated) {}

QuantisedMaps QuantisePass::run(const Texture& normal, const Texture& depth) const {
  QuantisedMaps result{Texture("normal, 8 bits", TextureFormat::rgba8, normal.width_px(), normal.height_px()),
                       Texture("depth, 8 bits", TextureFormat::r8, depth.width_px(), depth.height_px())};
  const RenderTarget target({&result.normal, &result.depth}, nullptr);
  program_.use();
  bind_textures({&normal, &depth});
  draw_full_screen();
  return result;
}

}  // namespace inkbench
