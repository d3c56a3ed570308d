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

/// How far from a pixel that a line touches the pixel of its nearest point can be, along a row or column. The
/// pixel's corner is 0.71 from its centre; two points in a row are at most 1.5 apart; a point lies up to half
/// a pixel from its own pixel's centre.
int reach_of(float half_px) {
  const float to_piece = half_px + 0.71F;
  return static_cast<int>(std::sqrt(to_piece * to_piece + 0.75F * 0.75F) + 0.5F);
}

}  // namespace

bool lines_are_narrow(const Settings& settings) {
  if (widths_need_range(settings)) return false;
  return widest_half_px(widths_of(settings), {}, settings.image.height, nullptr) <= kMostHalfPx;
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
  const int reach_px = reach_of(widest_half_px(widths, lens, placed.height_px(), nullptr));
  const Buffer count = coverage_buffer({samples, reach_px, {}});
  const Buffer line = block_buffer(widths.line), lens_uniforms = lens_buffer(lens);
  const Buffer factors = widths_buffer(widths, placed.height_px(), false);
  draw_over_tiles(ink, program_, reach_px, {&placed, &tiles, &gbuffer.normal_and_depth},
                  {&count, &line, &lens_uniforms, &factors});
  return ink;
}

}  // namespace inkbench
