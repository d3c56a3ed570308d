// SPDX-License-Identifier: MIT
#include "pipeline/passes/ink/published_look.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/edges/found_edges.h"
#include "pipeline/passes/placing/edge_classes.h"
#include "pipeline/passes/placing/edge_tiles.h"
#include "pipeline/passes/placing/tiles.h"

namespace inkbench {

const PassKind& PublishedLookPass::kind() {
  static const PassKind kKind = describe_pass<PublishedLookPass>(
      "published_look", 2, {}, part<&Settings::edges, &EdgesParams::method>(), value_of<FoundEdges>(),
      value_of<EdgeClassPass>(), value_of<EdgeTilesPass>());
  return kKind;
}

PublishedLookPass::PublishedLookPass(const GeneratedSources& generated)
    : grey_("full_screen.vert", "published_look.frag", {.samplers = {"detection_map", "class_map"}},
            generated),
      dilated_("tiles.vert", "dilated_look.frag",
               {.samplers = {"detection_map", "class_map", "tile_map"}, .uniform_blocks = {kSquaresBlock}},
               generated) {}

Texture PublishedLookPass::run(EdgeMethod method, const Texture& detection, const Texture& classes,
                               const Texture& tiles) const {
  Texture ink("published look", TextureFormat::rg8, detection.width_px(), detection.height_px());
  if (method == EdgeMethod::mitchell)
    draw_over_tiles(ink, dilated_, 1, {&detection, &classes, &tiles}, {});
  else
    draw_over(ink, grey_, {&detection, &classes}, {});
  return ink;
}

}  // namespace inkbench
