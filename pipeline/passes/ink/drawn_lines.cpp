// SPDX-License-Identifier: MIT
#include "pipeline/passes/ink/drawn_lines.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/ink/drawn_ink.h"

namespace inkbench {
namespace {

constexpr BufferInfo kLines{.name = "lines",
                            .help = "The drawn lines as they are measured, white on black.",
                            .as_lines = ReadAsLines::at_cut};
constexpr BufferInfo kCoverage{.name = "coverage",
                               .help = "How much of each pixel is ink; from a half on it is a line.",
                               .first_channel = 1,
                               .as_lines = ReadAsLines::at_cut,
                               .is_supersampled = true};

/// What is drawn is the paper's combined edges, and nothing else.
bool draws_papers_ink(const Settings& settings) {
  return settings.ink.from == InkFrom::filter && is_papers_ink(settings);
}

/// lines_block of shaders/lines.frag in std140.
struct LinesBlock {
  int is_papers;
  int padding[3];
};

}  // namespace

constinit const BufferName BufferName::lines{kLines};
constinit const BufferName BufferName::coverage{kCoverage};

const PassKind& LinesPass::kind() {
  static const PassKind kKind =
      describe_pass<LinesPass>("lines", 1, {shows(BufferName::lines), shows(BufferName::coverage)},
                               derived<draws_papers_ink>(EdgesParams::description), value_of<DrawnInk>());
  return kKind;
}

LinesPass::LinesPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "lines.frag",
               {.samplers = {"drawn_map"}, .uniform_blocks = {{"lines_block", sizeof(LinesBlock)}}},
               generated) {}

Texture LinesPass::run(bool is_papers, const Texture& drawn) const {
  Texture lines("lines", TextureFormat::rg8, drawn.width_px(), drawn.height_px());
  const LinesBlock block{is_papers ? 1 : 0, {}};
  const Buffer uniforms = uniform_buffer("lines block", block);
  draw_over(lines, program_, {&drawn}, {&uniforms});
  return lines;
}

}  // namespace inkbench
