#include "pipeline/passes/edges/gradient.h"

#include "pipeline/gl/framebuffer.h"

namespace inkbench {

GradientPass::GradientPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "gradient.frag", {.samplers = {"normal_and_depth_map"}}, generated) {}

Texture GradientPass::run(const Texture& normal_and_depth, Precision precision) const {
  const TextureFormat format = precision == Precision::float32 ? TextureFormat::rg32f : TextureFormat::rg8;
  Texture gradient("gradient", format, normal_and_depth.width_px(), normal_and_depth.height_px());
  const RenderTarget target({&gradient}, nullptr);
  program_.use();
  bind_textures({&normal_and_depth});
  draw_full_screen();
  return gradient;
}

}  // namespace inkbench
