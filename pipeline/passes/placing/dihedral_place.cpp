// SPDX-License-Identifier: MIT
#include "pipeline/passes/placing/dihedral_place.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/edges/shaded_pairs.h"
#include "pipeline/passes/placing/dihedral_tiles.h"
#include "pipeline/passes/placing/tiles.h"

namespace inkbench {

const PassKind& DihedralPlacePass::kind() {
  static const PassKind kKind = describe_pass<DihedralPlacePass>(
      "dihedral_place", 3, {}, group<&Settings::dihedral>(), part<&Settings::edges, &EdgesParams::weak>(),
      value_of<ShadedPairsPass>(), value_of<DihedralTilesPass>());
  return kKind;
}

DihedralPlacePass::DihedralPlacePass(const GeneratedSources& generated)
    : program_("tiles.vert", "dihedral_place.frag",
               {.samplers = {"pair_map", "tile_map"},
                .uniform_blocks = {block_of(EdgesParams::description()),
                                   block_of(DihedralParams::description()), kSquaresBlock}},
               generated) {}

Texture DihedralPlacePass::run(const DihedralParams& params, float weak, const Texture& pairs,
                               const Texture& tiles) const {
  Texture placed("placed lines", TextureFormat::rgba8, pairs.width_px(), pairs.height_px());
  const Buffer edges = weak_block(weak), limits = block_buffer(params);
  draw_over_tiles(placed, program_, 0, {&pairs, &tiles}, {&edges, &limits});
  return placed;
}

}  // namespace inkbench
