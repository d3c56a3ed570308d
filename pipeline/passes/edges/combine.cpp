// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/combine.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/gl/framebuffer.h"
#include "pipeline/params/glsl_block.h"
#include "pipeline/passes/edges/range.h"

namespace inkbench {
namespace {

constexpr BufferInfo kCombinedEdges{.name = "combined_edges",
                                    .help = "Where the terms of both edges sum up to a line.",
                                    .number_key = 5,
                                    .as_lines = ReadAsLines::above_0};

}  // namespace

constinit const BufferName BufferName::combined_edges{kCombinedEdges};

const PassKind& CombinePass::kind() {
  static const PassKind kKind = describe_pass<CombinePass>("combine", 2, {shows(BufferName::combined_edges)},
                                                           group<&Settings::combine>(), value_of<RangePass>(),
                                                           part<&Settings::image, &ImageParams::precision>());
  return kKind;
}

CombinePass::CombinePass(const GeneratedSources& generated)
    : program_("full_screen.vert", "combine.frag",
               {.samplers = {"range_map"}, .uniform_blocks = {block_of(CombineParams::description())}},
               generated) {}

Texture CombinePass::run(const CombineParams& params, const Texture& range, Precision precision) const {
  const TextureFormat format = precision == Precision::unorm8 ? TextureFormat::r8 : TextureFormat::r32f;
  Texture edges("combined edges", format, range.width_px(), range.height_px());
  const RenderTarget target({&edges}, nullptr);
  const Buffer uniforms("combine block", pack_std140(CombineParams::description(), &params));
  program_.use();
  bind_uniform_blocks({&uniforms});
  bind_textures({&range});
  draw_full_screen();
  return edges;
}

}  // namespace inkbench
