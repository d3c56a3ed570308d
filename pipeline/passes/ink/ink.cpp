// SPDX-License-Identifier: MIT
#include "pipeline/passes/ink/ink.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/gl/framebuffer.h"
#include "pipeline/params/glsl_block.h"
#include "pipeline/passes/edges/combine.h"
#include "pipeline/passes/light/shade.h"

namespace inkbench {
namespace {

constexpr BufferInfo kFinal{.name = "final",
                            .help = "Ink over the shading.",
                            .number_key = 7,
                            .channels = 3,
                            .shown_as = ShownAs::colour};

}  // namespace

constinit const BufferName BufferName::final{kFinal};

const PassKind& InkPass::kind() {
  static const PassKind kKind =
      describe_pass<InkPass>("ink", 1, {shows(BufferName::final)}, group<&Settings::ink>(),
                             value_of<ShadePass>(), value_of<CombinePass>());
  return kKind;
}

InkPass::InkPass(const GeneratedSources& generated)
    : program_(
          "full_screen.vert", "ink.frag",
          {.samplers = {"shaded_map", "edge_map"}, .uniform_blocks = {block_of(InkParams::description())}},
          generated) {}

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
