// SPDX-License-Identifier: MIT
#include "pipeline/passes/ink/flood.h"

#include <algorithm>
#include <cmath>

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/gbuffer/visible_range.h"
#include "pipeline/passes/ink/seeds.h"

namespace inkbench {
namespace {

/// flood_block of shaders/flood.frag in std140.
struct FloodBlock {
  int step_px;
  int padding[3];
};

/// The pixels that a line of that half width can touch lie no farther from the pixel of its point.
int reach_px(float half_px, const Texture& image) {
  const auto side = static_cast<float>(std::max(image.width_px(), image.height_px()));
  return static_cast<int>(std::ceil(std::min(half_px, side) + 1.0F));
}

}  // namespace

const PassKind& FloodPass::kind() {
  static const PassKind kKind =
      describe_pass<FloodPass>("flood", 8, {}, WidthInput{}, LensInput{}, value_of<SeedsPass>(),
                               value_when<VisibleRangePass, widths_need_range>());
  return kKind;
}

FloodPass::FloodPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "flood.frag",
               {.samplers = {"seed_map"}, .uniform_blocks = {{"flood_block", sizeof(FloodBlock)}}},
               generated) {}

Texture FloodPass::run(const WidthParams& widths, const LensBlock& lens, const Texture& seeds,
                       const Texture* visible) const {
  const int reach = reach_px(widest_half_px(widths, lens, visible), seeds);
  int step = 1;
  while (2 * step <= reach) step *= 2;
  Texture flooded;
  for (const Texture* from = &seeds; step >= 1; step /= 2, from = &flooded) {
    Texture next("flood", TextureFormat::rgba32f, seeds.width_px(), seeds.height_px());
    const FloodBlock block{step, {}};
    const Buffer uniforms = uniform_buffer("flood block", block);
    draw_over(next, program_, {from}, {&uniforms});
    flooded = std::move(next);
  }
  return flooded;
}

}  // namespace inkbench
