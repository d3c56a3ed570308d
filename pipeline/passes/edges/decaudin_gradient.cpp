// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/decaudin_gradient.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/gbuffer/quantise.h"

namespace inkbench {

const PassKind& DecaudinGradientPass::kind() {
  static const PassKind kKind =
      describe_pass<DecaudinGradientPass>("decaudin_gradient", 8, {}, value_of<QuantisePass>());
  return kKind;
}

DecaudinGradientPass::DecaudinGradientPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "decaudin_gradient.frag", {.samplers = {"normal_and_depth_map"}},
               generated) {}

Texture DecaudinGradientPass::run(const Texture& normal_and_depth) const {
  Texture gradient("Decaudin's gradient", TextureFormat::rgba32f, normal_and_depth.width_px(),
                   normal_and_depth.height_px());
  draw_over(gradient, program_, {&normal_and_depth}, {});
  return gradient;
}

}  // namespace inkbench
