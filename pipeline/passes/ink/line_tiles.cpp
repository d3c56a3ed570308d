// SPDX-License-Identifier: MIT
#include "pipeline/passes/ink/line_tiles.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/placing/connect.h"

namespace inkbench {

const PassKind& LineTilesPass::kind() {
  static const PassKind kKind = describe_pass<LineTilesPass>("line_tiles", 1, {}, value_of<ConnectPass>());
  return kKind;
}

LineTilesPass::LineTilesPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "line_tiles.frag", {.samplers = {"placed_map"}}, generated) {}

Texture LineTilesPass::run(const Texture& placed) const {
  Texture tiles("line tiles", TextureFormat::r8, (placed.width_px() + 7) / 8, (placed.height_px() + 7) / 8);
  draw_over(tiles, program_, {&placed}, {});
  return tiles;
}

}  // namespace inkbench
