#include "pipeline/passes/ink/ink.h"

#include "pipeline/gl/framebuffer.h"
#include "pipeline/params/glsl_block.h"

namespace inkbench {

InkPass::InkPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "ink.frag",
               {.samplers = {"shaded_map", "edge_map"}, .uniform_blocks = {"ink_block"}}, generated) {}

Texture InkPass::run(const InkParams& params, const Texture& shaded, const Texture& edges) const {
  Texture final("final", TextureFormat::rgba32f, shaded.width_px(), shaded.height_px());
  const RenderTarget target({&final}, nullptr);
  const Buffer uniforms("ink block", pack_std140(InkParams::description(), &params));
  program_.use();
  bind_uniform_blocks({&uniforms});
  bind_textures({&shaded, &edges});
  draw_full_screen();
  return final;
}

}  // namespace inkbench
