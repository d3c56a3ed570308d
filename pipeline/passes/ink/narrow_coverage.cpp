// SPDX-License-Identifier: MIT
#include "pipeline/passes/ink/narrow_coverage.h"

#include <array>
#include <cmath>

#include "pipeline/flow/describe_choice.h"
#include "pipeline/gl/framebuffer.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/ink/coverage.h"
#include "pipeline/passes/ink/line_tiles.h"
#include "pipeline/passes/placing/connect.h"

namespace inkbench {
namespace {

constexpr float kMostHalfPx = 2.0F;

/// squares_block of shaders/tiles.vert in std140.
struct SquaresBlock {
  int width_px, height_px;
  int reach_px;
  int columns;
};

/// Along a side of the image.
int squares(int side_px) {
  return (side_px + 15) / 16;
}

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
  return widest_half_px(widths_of(settings), {}, glm::vec2(0.0F)) <= kMostHalfPx;
}

const PassKind& NarrowCoveragePass::kind() {
  static const PassKind kKind = describe_pass<NarrowCoveragePass>(
      "narrow_coverage", 4, {}, derived<drawn_samples>(LineParams::description), WidthInput{}, LensInput{},
      value_of<ConnectPass>(), value_of<LineTilesPass>(), value_of<GBufferPass>());
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
                .uniform_blocks = {kCoverageBlock,
                                   block_of(LineParams::description()),
                                   kLensBlock,
                                   kWidthsBlock,
                                   {"squares_block", sizeof(SquaresBlock)}}},
               generated) {}

Texture NarrowCoveragePass::run(int samples, const WidthParams& widths, const LensBlock& lens,
                                const Texture& placed, const Texture& tiles, const GBuffer& gbuffer) const {
  Texture ink("narrow coverage", TextureFormat::rg8, placed.width_px(), placed.height_px());
  const int reach_px = reach_of(widest_half_px(widths, lens, glm::vec2(0.0F)));
  const Buffer count = coverage_buffer({samples, reach_px, {}});
  const Buffer line = block_buffer(widths.line), lens_uniforms = lens_buffer(lens);
  const Buffer factors = widths_buffer(widths, false);
  const SquaresBlock block{placed.width_px(), placed.height_px(), reach_px, squares(placed.width_px())};
  const Buffer squares_uniforms("squares block", bytes_of(std::span<const SquaresBlock>(&block, 1)));
  const RenderTarget target({&ink}, nullptr);
  constexpr std::array kNoInk{0.0F, 0.0F, 0.0F, 0.0F};
  glClearBufferfv(GL_COLOR, 0, kNoInk.data());
  program_.use();
  bind_uniform_blocks({&count, &line, &lens_uniforms, &factors, &squares_uniforms});
  bind_textures({&placed, &tiles, &gbuffer.normal_and_depth});
  draw_strips(4, squares(placed.width_px()) * squares(placed.height_px()));
  return ink;
}

}  // namespace inkbench
