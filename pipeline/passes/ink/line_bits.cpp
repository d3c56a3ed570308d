// SPDX-License-Identifier: MIT
#include "pipeline/passes/ink/line_bits.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/placing/connect.h"
#include "pipeline/passes/placing/line_tiles.h"
#include "pipeline/passes/placing/tiles.h"

namespace inkbench {

const PassKind& LineBitsPass::kind() {
  static const PassKind kKind = describe_pass<LineBitsPass>("line_bits", 1, {}, ClassWidthInput{},
                                                            value_of<ConnectPass>(), value_of<LineTiles>());
  return kKind;
}

LineBitsPass::LineBitsPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "line_bits.frag",
               {.samplers = {"placed_map", "tile_map"}, .uniform_blocks = {kWidthsBlock}}, generated) {}

Texture LineBitsPass::run(const WidthParams& widths, const Texture& placed, const Texture& tiles) const {
  Texture bits("line bits", TextureFormat::rg32ui, tiles.width_px(), tiles.height_px());
  const Buffer factors = widths_buffer(widths, false);
  draw_over(bits, program_, {&placed, &tiles}, {&factors});
  return bits;
}

}  // namespace inkbench
