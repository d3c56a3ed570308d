// SPDX-License-Identifier: MIT
#include "pipeline/passes/ink/coverage.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/ink/flood.h"

namespace inkbench {
namespace {

template <int count>
int fixed_samples(const Settings&) {
  return count;
}

template <class Tag, auto kSamples>
PassKind describe_coverage(std::string_view name, int cost) {
  return describe_pass<Tag>(name, cost, {}, derived<kSamples>(LineParams::description), LensInput{},
                            value_of<FloodPass>(), value_of<GBufferPass>());
}

}  // namespace

Buffer coverage_buffer(const CoverageBlock& block) {
  return uniform_buffer("coverage block", block);
}

int drawn_samples(const Settings& settings) {
  return settings.line.antialias ? 0 : 1;
}

const PassKind& CoveragePass::kind() {
  static const PassKind kKind = describe_coverage<CoveragePass, drawn_samples>("coverage", 4);
  return kKind;
}

const PassKind& AliasedCoverage::kind() {
  static const PassKind kKind = describe_coverage<AliasedCoverage, fixed_samples<1>>("aliased_coverage", 4);
  return kKind;
}

const PassKind& SampledCoverage::kind() {
  static const PassKind kKind = describe_coverage<SampledCoverage, fixed_samples<8>>("sampled_coverage", 60);
  return kKind;
}

CoveragePass::CoveragePass(const GeneratedSources& generated)
    : program_(
          "full_screen.vert", "coverage.frag",
          {.samplers = {"seed_map", "normal_and_depth_map"}, .uniform_blocks = {kCoverageBlock, kLensBlock}},
          generated) {}

Texture CoveragePass::run(int samples, const LensBlock& lens, const Texture& nearest,
                          const GBuffer& gbuffer) const {
  Texture ink("coverage", TextureFormat::rg8, nearest.width_px(), nearest.height_px());
  const Buffer count = coverage_buffer({samples, 0, {}});
  const Buffer lens_uniforms = lens_buffer(lens);
  draw_over(ink, program_, {&nearest, &gbuffer.normal_and_depth}, {&count, &lens_uniforms});
  return ink;
}

}  // namespace inkbench
