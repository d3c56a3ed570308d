// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/decaudin.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/decaudin_gradient.h"
#include "pipeline/passes/edges/detection_pass.h"

namespace inkbench {

const PassKind& DecaudinPass::kind() {
  static const PassKind kKind = describe_pass<DecaudinPass>("decaudin", 6, {}, group<&Settings::decaudin>(),
                                                            part<&Settings::edges, &EdgesParams::weak>(),
                                                            value_of<DecaudinGradientPass>());
  return kKind;
}

DecaudinPass::DecaudinPass(const GeneratedSources& generated)
    : program_(
          "full_screen.vert", "decaudin.frag",
          {.samplers = {"gradient_map"},
           .uniform_blocks = {block_of(EdgesParams::description()), block_of(DecaudinParams::description())}},
          generated) {}

Texture DecaudinPass::run(const DecaudinParams& params, float weak, const Texture& gradient) const {
  Texture detection = detection_target("decaudin", gradient);
  const Buffer edges = weak_block(weak), limits = block_buffer(params);
  draw_over(detection, program_, {&gradient}, {&edges, &limits});
  return detection;
}

}  // namespace inkbench
