// SPDX-License-Identifier: MIT
#include "pipeline/passes/ink/narrow_coverage.h"

#include <algorithm>
#include <cmath>

#include "pipeline/flow/describe_choice.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/ink/coverage.h"
#include "pipeline/passes/ink/line_bits.h"
#include "pipeline/passes/placing/connect.h"
#include "pipeline/passes/placing/tiles.h"

namespace inkbench {
namespace {

constexpr float kMostHalfPx = 2.0F;
constexpr int kReachPx = 3;  // of the widest of them

/// How far from the centre of a pixel that a line touches the line's nearest point can be: the pixel's corner
/// is 0.71 from its centre, and two points in a row are at most 1.5 apart.
float farthest_point(float half_px) {
  const float to_piece = half_px + 0.71F;
  return std::sqrt(to_piece * to_piece + 0.75F * 0.75F);
}

/// In the row `dy` above or below a pixel, how far to its sides the pixels lie of which some point, up to
/// half a pixel from the pixel's centre along both axes, is as near as `farthest`.
int span_px(float farthest, int dy) {
  const float rise = std::max(std::abs(static_cast<float>(dy)) - 0.5F, 0.0F);
  return static_cast<int>(std::sqrt(std::max(farthest * farthest - rise * rise, 0.0F)) + 0.5F);
}

/// A bit for each pixel from `kReachPx` to the left and below on, 8 x 8 of them.
void set_within(CoverageBlock& block, float farthest) {
  for (int dy = -kReachPx; dy <= kReachPx; ++dy) {
    if (std::abs(dy) > span_px(farthest, 0)) continue;
    const int span = span_px(farthest, dy);
    for (int dx = -span; dx <= span; ++dx) {
      const int bit = 8 * (dy + kReachPx) + dx + kReachPx;
      block.within[bit / 32] |= 1U << (bit % 32);
    }
  }
}

}  // namespace

bool lines_are_narrow(const Settings& settings) {
  if (widths_need_range(settings)) return false;
  return widest_half_px(widths_of(settings), {}, glm::vec2(0.0F)) <= kMostHalfPx;
}

const PassKind& NarrowCoveragePass::kind() {
  static const PassKind kKind = describe_pass<NarrowCoveragePass>(
      "narrow_coverage", 4, {}, derived<drawn_samples>(LineParams::description), WidthInput{}, LensInput{},
      value_of<ConnectPass>(), value_of<LineBitsPass>(), value_of<GBufferPass>());
  return kKind;
}

const PassKind& LineCoverage::kind() {
  static const PassKind kKind = describe_choice<LineCoverage, NarrowCoveragePass, CoveragePass>(
      "line_coverage", LineParams::description().group, {});
  return kKind;
}

NarrowCoveragePass::NarrowCoveragePass(const GeneratedSources& generated)
    : program_("tiles_near_lines.vert", "narrow_coverage.frag",
               {.samplers = {"placed_map", "bit_map", "normal_and_depth_map"},
                .uniform_blocks = {kCoverageBlock, block_of(LineParams::description()), kLensBlock,
                                   kWidthsBlock, kSquaresBlock}},
               generated) {}

Texture NarrowCoveragePass::run(int samples, const WidthParams& widths, const LensBlock& lens,
                                const Texture& placed, const Texture& bits, const GBuffer& gbuffer) const {
  Texture ink("narrow coverage", TextureFormat::rg8, placed.width_px(), placed.height_px());
  const float farthest = farthest_point(widest_half_px(widths, lens, glm::vec2(0.0F)));
  CoverageBlock block{samples, 0, {}};
  set_within(block, farthest);
  const Buffer count = coverage_buffer(block);
  const Buffer line = block_buffer(widths.line), lens_uniforms = lens_buffer(lens);
  const Buffer factors = widths_buffer(widths, false);
  draw_over_tiles(ink, program_, span_px(farthest, 0), {&placed, &bits, &gbuffer.normal_and_depth},
                  {&count, &line, &lens_uniforms, &factors});
  return ink;
}

}  // namespace inkbench
