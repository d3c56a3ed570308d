// SPDX-License-Identifier: MIT
#include "pipeline/passes/placing/line_tiles.h"

#include "pipeline/flow/describe_choice.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/placing/connect.h"
#include "pipeline/passes/placing/dihedral_tiles.h"
#include "pipeline/passes/placing/tiles.h"

namespace inkbench {

const PassKind& LineTilesPass::kind() {
  static const PassKind kKind = describe_pass<LineTilesPass>("line_tiles", 1, {}, value_of<ConnectPass>());
  return kKind;
}

size_t LineTiles::chosen(const Settings& settings) {
  return settings.edges.method == EdgeMethod::dihedral ? 1 : 0;
}

const PassKind& LineTiles::kind() {
  static const PassKind kKind = describe_choice<LineTiles, LineTilesPass, DihedralTilesPass>(
      "tiles", EdgesParams::description().group, {});
  return kKind;
}

LineTilesPass::LineTilesPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "line_tiles.frag", {.samplers = {"placed_map"}}, generated) {}

Texture LineTilesPass::run(const Texture& placed) const {
  Texture tiles("line tiles", TextureFormat::r8, tiles_along(placed.width_px()),
                tiles_along(placed.height_px()));
  draw_over(tiles, program_, {&placed}, {});
  return tiles;
}

}  // namespace inkbench
