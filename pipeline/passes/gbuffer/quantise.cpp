#include "pipeline/passes/gbuffer/quantise.h"

#include "pipeline/gl/framebuffer.h"

namespace inkbench {

QuantisePass::QuantisePass(const GeneratedSources& generated)
    : program_("full_screen.vert", "quantise.frag", {.samplers = {"normal_and_depth_map"}}, generated) {}

Texture QuantisePass::run(const Texture& normal_and_depth) const {
  Texture result("normal and depth, 8 bits", TextureFormat::rgba8, normal_and_depth.width_px(),
                 normal_and_depth.height_px());
  const RenderTarget target({&result}, nullptr);
  program_.use();
  bind_textures({&normal_and_depth});
  draw_full_screen();
  return result;
}

}  // namespace inkbench
