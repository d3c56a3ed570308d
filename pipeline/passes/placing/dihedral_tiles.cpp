// SPDX-License-Identifier: MIT
#include "pipeline/passes/placing/dihedral_tiles.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/edges/shaded_pairs.h"
#include "pipeline/passes/placing/tiles.h"

namespace inkbench {

const PassKind& PairTilesPass::kind() {
  static const PassKind kKind =
      describe_pass<PairTilesPass>("pair_tiles", 2, {}, value_of<ShadedPairsPass>());
  return kKind;
}

PairTilesPass::PairTilesPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "pair_tiles.frag", {.samplers = {"pair_map"}}, generated) {}

Texture PairTilesPass::run(const Texture& pairs) const {
  Texture largest("pair tiles", TextureFormat::rg32f, tiles_along(pairs.width_px()),
                  tiles_along(pairs.height_px()));
  draw_over(largest, program_, {&pairs}, {});
  return largest;
}

const PassKind& DihedralTilesPass::kind() {
  static const PassKind kKind = describe_pass<DihedralTilesPass>(
      "dihedral_tiles", 1, {}, group<&Settings::dihedral>(), part<&Settings::edges, &EdgesParams::weak>(),
      value_of<PairTilesPass>());
  return kKind;
}

DihedralTilesPass::DihedralTilesPass(const GeneratedSources& generated)
    : program_(
          "full_screen.vert", "dihedral_tiles.frag",
          {.samplers = {"largest_map"},
           .uniform_blocks = {block_of(DihedralParams::description()), block_of(EdgesParams::description())}},
          generated) {}

Texture DihedralTilesPass::run(const DihedralParams& params, float weak, const Texture& largest) const {
  Texture tiles("dihedral tiles", TextureFormat::r8, largest.width_px(), largest.height_px());
  const Buffer limits = block_buffer(params), edges = weak_block(weak);
  draw_over(tiles, program_, {&largest}, {&limits, &edges});
  return tiles;
}

}  // namespace inkbench
