// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/published_look.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/edges/found_edges.h"

namespace inkbench {

const PassKind& PublishedLookPass::kind() {
  static const PassKind kKind = describe_pass<PublishedLookPass>(
      "published_look", 2, {}, part<&Settings::edges, &EdgesParams::method>(), value_of<FoundEdges>());
  return kKind;
}

PublishedLookPass::PublishedLookPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "published_look.frag",
               {.samplers = {"detection_map"}, .uniform_blocks = {block_of(EdgesParams::description())}},
               generated) {}

Texture PublishedLookPass::run(EdgeMethod method, const Texture& detection) const {
  Texture ink("published look", TextureFormat::rg8, detection.width_px(), detection.height_px());
  EdgesParams params;
  params.method = method;
  const Buffer edges = block_buffer(params);
  draw_over(ink, program_, {&detection}, {&edges});
  return ink;
}

}  // namespace inkbench
