// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/drawn_lines.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/gl/framebuffer.h"
#include "pipeline/passes/edges/combine.h"

namespace inkbench {
namespace {

constexpr BufferInfo kLines{.name = "lines",
                            .help = "The drawn lines as they are measured, white on black.",
                            .as_lines = ReadAsLines::at_cut};

}  // namespace

constinit const BufferName BufferName::lines{kLines};

const PassKind& LinesPass::kind() {
  static const PassKind kKind =
      describe_pass<LinesPass>("lines", 1, {shows(BufferName::lines)}, value_of<CombinePass>());
  return kKind;
}

LinesPass::LinesPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "lines.frag", {.samplers = {"edge_map"}}, generated) {}

Texture LinesPass::run(const Texture& edges) const {
  Texture lines("lines", TextureFormat::r8, edges.width_px(), edges.height_px());
  const RenderTarget target({&lines}, nullptr);
  program_.use();
  bind_textures({&edges});
  draw_full_screen();
  return lines;
}

}  // namespace inkbench
