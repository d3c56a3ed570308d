// SPDX-License-Identifier: MIT
#include "pipeline/passes/ink/both_inks.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/ink/drawn_ink.h"
#include "pipeline/passes/strokes/stroke_ink.h"

namespace inkbench {
namespace {

/// both_inks_block of shaders/both_inks.frag in std140.
struct BothInksBlock {
  int is_papers;
  int padding[3];
};

}  // namespace

const PassKind& BothInksPass::kind() {
  static const PassKind kKind =
      describe_pass<BothInksPass>("both_inks", 1, {}, derived<is_papers_ink>(EdgesParams::description),
                                  value_of<FilterInk>(), value_of<StrokeInkPass>());
  return kKind;
}

BothInksPass::BothInksPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "both_inks.frag",
               {.samplers = {"filter_map", "stroke_map"},
                .uniform_blocks = {{"both_inks_block", sizeof(BothInksBlock)}}},
               generated) {}

Texture BothInksPass::run(bool is_papers, const Texture& filter, const Texture& strokes) const {
  Texture ink("both inks", TextureFormat::rg8, filter.width_px(), filter.height_px());
  const BothInksBlock block{is_papers ? 1 : 0, {}};
  const Buffer uniforms = uniform_buffer("both inks block", block);
  draw_over(ink, program_, {&filter, &strokes}, {&uniforms});
  return ink;
}

}  // namespace inkbench
