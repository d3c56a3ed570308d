// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/laplacian.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/gbuffer/quantise.h"

namespace inkbench {

const PassKind& LaplacianPass::kind() {
  static const PassKind kKind = describe_pass<LaplacianPass>(
      "laplacian", 6, {}, group<&Settings::laplacian>(), part<&Settings::edges, &EdgesParams::weak>(),
      LensInput{}, value_of<QuantisePass>());
  return kKind;
}

LaplacianPass::LaplacianPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "laplacian.frag",
               {.samplers = {"normal_and_depth_map"},
                .uniform_blocks = {block_of(EdgesParams::description()),
                                   block_of(LaplacianParams::description()), kLensBlock}},
               generated) {}

Texture LaplacianPass::run(const LaplacianParams& params, float weak, const LensBlock& lens,
                           const Texture& normal_and_depth) const {
  Texture detection = detection_target("laplacian", normal_and_depth);
  const Buffer edges = weak_block(weak), limits = block_buffer(params), lens_uniforms = lens_buffer(lens);
  draw_over(detection, program_, {&normal_and_depth}, {&edges, &limits, &lens_uniforms});
  return detection;
}

}  // namespace inkbench
