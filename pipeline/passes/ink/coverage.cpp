// SPDX-License-Identifier: MIT
#include "pipeline/passes/ink/coverage.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/ink/flood.h"

namespace inkbench {

const PassKind& CoveragePass::kind() {
  static const PassKind kKind =
      describe_pass<CoveragePass>("coverage", 4, {}, part<&Settings::line, &LineParams::antialias>(),
                                  LensInput{}, value_of<FloodPass>(), value_of<GBufferPass>());
  return kKind;
}

CoveragePass::CoveragePass(const GeneratedSources& generated)
    : program_("full_screen.vert", "coverage.frag",
               {.samplers = {"seed_map", "normal_and_depth_map"},
                .uniform_blocks = {block_of(LineParams::description()), kLensBlock}},
               generated) {}

Texture CoveragePass::run(bool antialias, const LensBlock& lens, const Texture& nearest,
                          const GBuffer& gbuffer) const {
  Texture ink("coverage", TextureFormat::rg32f, nearest.width_px(), nearest.height_px());
  LineParams params;
  params.antialias = antialias;
  const Buffer line = block_buffer(params), lens_uniforms = lens_buffer(lens);
  draw_over(ink, program_, {&nearest, &gbuffer.normal_and_depth}, {&line, &lens_uniforms});
  return ink;
}

}  // namespace inkbench
