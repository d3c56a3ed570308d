// SPDX-License-Identifier: MIT
#include "pipeline/passes/placing/place.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/lines/thinning.h"
#include "pipeline/passes/edges/found_edges.h"
#include "pipeline/passes/placing/candidates.h"
#include "pipeline/passes/placing/edge_classes.h"
#include "pipeline/passes/placing/edge_tiles.h"
#include "pipeline/passes/placing/tiles.h"

namespace inkbench {
namespace {

Texture thinned_texture(const Texture& candidates) {
  Image values = candidates.read(0, 1);
  LineMap map(values.width_px, values.height_px);
  for (int y = 0; y < values.height_px; ++y) {
    for (int x = 0; x < values.width_px; ++x) map.set(x, y, values.at(x, y) > 0.5F);
  }
  const LineMap thin = thinned(map);
  for (int y = 0; y < values.height_px; ++y) {
    for (int x = 0; x < values.width_px; ++x) values.at(x, y) = thin.at(x, y) ? 1.0F : 0.0F;
  }
  Texture result("thinned", TextureFormat::r8, values.width_px, values.height_px);
  result.upload(values);
  return result;
}

}  // namespace

const PassKind& PlacePass::kind() {
  static const PassKind kKind =
      describe_pass<PlacePass>("place", 5, {}, value_of<FoundEdges>(), value_of<EdgeClassPass>(),
                               value_of<EdgeTilesPass>(), value_of<CandidatesPass>());
  return kKind;
}

PlacePass::PlacePass(const GeneratedSources& generated)
    : program_("tiles.vert", "place.frag",
               {.samplers = {"detection_map", "class_map", "candidate_map", "thinned_map", "tile_map"},
                .uniform_blocks = {kSquaresBlock}},
               generated) {}

Texture PlacePass::run(const Texture& detection, const Texture& classes, const Texture& tiles,
                       const Texture& candidates) const {
  const Texture thin = thinned_texture(candidates);
  Texture placed("placed lines", TextureFormat::rgba8, detection.width_px(), detection.height_px());
  draw_over_tiles(placed, program_, 0, {&detection, &classes, &candidates, &thin, &tiles}, {});
  return placed;
}

}  // namespace inkbench
