// SPDX-License-Identifier: MIT
#include "pipeline/passes/placing/edge_classes.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/found_edges.h"
#include "pipeline/passes/gbuffer/quantise.h"
#include "pipeline/passes/placing/edge_tiles.h"
#include "pipeline/passes/placing/tiles.h"

namespace inkbench {
namespace {

constexpr BufferInfo kEdgeClass{.name = "edge_class",
                                .help =
                                    "What each detected pixel is of: object, silhouette, crease, normal, "
                                    "shadow or material.",
                                .shown_as = ShownAs::edge_class};

}  // namespace

constinit const BufferName BufferName::edge_class{kEdgeClass};

const PassKind& EdgeClassPass::kind() {
  static const PassKind kKind = describe_pass<EdgeClassPass>(
      "edge_class", 3, {shows(BufferName::edge_class)}, LensInput{}, value_of<FoundEdges>(),
      value_of<EdgeTilesPass>(), value_of<QuantisePass>(), value_of<GBufferPass>());
  return kKind;
}

EdgeClassPass::EdgeClassPass(const GeneratedSources& generated)
    : program_("tiles.vert", "edge_class.frag",
               {.samplers = {"detection_map", "normal_and_depth_map", "object_id_map", "tile_map"},
                .uniform_blocks = {kLensBlock, kSquaresBlock}},
               generated) {}

Texture EdgeClassPass::run(const LensBlock& lens, const Texture& detection, const Texture& tiles,
                           const Texture& normal_and_depth, const GBuffer& gbuffer) const {
  Texture classes("edge classes", TextureFormat::r32f, detection.width_px(), detection.height_px());
  const Buffer lens_uniforms = lens_buffer(lens);
  draw_over_tiles(classes, program_, 0, {&detection, &normal_and_depth, &gbuffer.object_id, &tiles},
                  {&lens_uniforms});
  return classes;
}

}  // namespace inkbench
