// SPDX-License-Identifier: MIT
#include "pipeline/passes/placing/edge_tiles.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/edges/found_edges.h"
#include "pipeline/passes/placing/tiles.h"

namespace inkbench {

const PassKind& EdgeTilesPass::kind() {
  static const PassKind kKind = describe_pass<EdgeTilesPass>(
      "edge_tiles", 1, {}, part<&Settings::edges, &EdgesParams::weak>(), value_of<FoundEdges>());
  return kKind;
}

EdgeTilesPass::EdgeTilesPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "edge_tiles.frag",
               {.samplers = {"detection_map"}, .uniform_blocks = {block_of(EdgesParams::description())}},
               generated) {}

Texture EdgeTilesPass::run(float weak, const Texture& detection) const {
  Texture tiles("edge tiles", TextureFormat::r8, tiles_along(detection.width_px()),
                tiles_along(detection.height_px()));
  const Buffer edges = weak_block(weak);
  draw_over(tiles, program_, {&detection}, {&edges});
  return tiles;
}

}  // namespace inkbench
