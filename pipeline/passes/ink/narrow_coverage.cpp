// SPDX-License-Identifier: MIT
#include "pipeline/passes/ink/narrow_coverage.h"

#include <cmath>

#include "pipeline/flow/describe_choice.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/ink/coverage.h"
#include "pipeline/passes/placing/connect.h"
#include "pipeline/passes/placing/line_tiles.h"
#include "pipeline/passes/placing/tiles.h"

namespace inkbench {
namespace {

constexpr float kMostHalfPx = 2.0F;

/// How far from the centre of a pixel that a line touches the line's nearest point can be: the pixel's corner
/// is 0.71 from its centre, and two points in a row are at most 1.5 apart.
float farthest_point(float half_px) {
  const float to_piece = half_px + 0.71F;
  return std::sqrt(to_piece * to_piece + 0.75F * 0.75F);
}

}  // namespace

bool lines_are_narrow(const Settings& settings) {
  if (widths_need_range(settings)) return false;
  return widest_half_px(widths_of(settings), {}, glm::vec2(0.0F)) <= kMostHalfPx;
}

const PassKind& NarrowCoveragePass::kind() {
  static const PassKind kKind = describe_pass<NarrowCoveragePass>(
      "narrow_coverage", 4, {}, derived<drawn_samples>(LineParams::description), WidthInput{}, LensInput{},
      value_of<ConnectPass>(), value_of<LineTiles>(), value_of<GBufferPass>());
  return kKind;
}

const PassKind& LineCoverage::kind() {
  static const PassKind kKind = describe_choice<LineCoverage, NarrowCoveragePass, CoveragePass>(
      "line_coverage", LineParams::description().group, {});
  return kKind;
}

NarrowCoveragePass::NarrowCoveragePass(const GeneratedSources& generated)
    : program_("tiles.vert", "narrow_coverage.frag",
               {.samplers = {"placed_map", "tile_map", "normal_and_depth_map"},
                .uniform_blocks = {kCoverageBlock, block_of(LineParams::description()), kLensBlock,
                                   kWidthsBlock, kSquaresBlock}},
               generated) {}

Texture NarrowCoveragePass::run(int samples, const WidthParams& widths, const LensBlock& lens,
                                const Texture& placed, const Texture& tiles, const GBuffer& gbuffer) const {
  Texture ink("narrow coverage", TextureFormat::rg8, placed.width_px(), placed.height_px());
  const float farthest = farthest_point(widest_half_px(widths, lens, glm::vec2(0.0F)));
  const int reach_px =
      static_cast<int>(farthest + 0.5F);  // a point lies up to half a pixel from its own pixel's centre
  const Buffer count = coverage_buffer({samples, reach_px, farthest, 0});
  const Buffer line = block_buffer(widths.line), lens_uniforms = lens_buffer(lens);
  const Buffer factors = widths_buffer(widths, false);
  draw_over_tiles(ink, program_, reach_px, {&placed, &tiles, &gbuffer.normal_and_depth},
                  {&count, &line, &lens_uniforms, &factors});
  return ink;
}

}  // namespace inkbench
