// SPDX-License-Identifier: MIT
#include "pipeline/passes/gbuffer/visible_range.h"

#include <algorithm>

#include "pipeline/flow/describe_pass.h"
#include "pipeline/gl/framebuffer.h"

namespace inkbench {
namespace {

/// range_block of shaders/visible_range.frag in std140.
struct RangeBlock {
  float far;
  int is_first;
  int padding[2];
};

/// A side of the squares that one texel of the next smaller texture sums up.
constexpr int kSquare = 16;

int fewer(int texels) {
  return std::max((texels + kSquare - 1) / kSquare, 1);
}

Texture texture_of(const glm::vec2& visible) {
  Image values(1, 1, 2);
  values.at(0, 0, 0) = visible.x;
  values.at(0, 0, 1) = visible.y;
  Texture texture("visible range", TextureFormat::rg32f, 1, 1);
  texture.upload(values);
  return texture;
}

}  // namespace

const PassKind& VisibleRangePass::kind() {
  static const PassKind kKind =
      describe_pass<VisibleRangePass>("visible_range", 2, {}, part<&Settings::camera, &CameraParams::far>(),
                                      WindowInput{}, value_of<GBufferPass>());
  return kKind;
}

VisibleRangePass::VisibleRangePass(const GeneratedSources& generated)
    : program_("full_screen.vert", "visible_range.frag",
               {.samplers = {"value_map"}, .uniform_blocks = {{"range_block", sizeof(RangeBlock)}}},
               generated) {}

Texture VisibleRangePass::run(float far, const ImageWindow& window, const GBuffer& gbuffer) const {
  if (window.visible_range) return texture_of(*window.visible_range);
  const Texture* from = &gbuffer.normal_and_depth;
  Texture range;
  RangeBlock block{far, 1, {}};
  do {
    Texture next("visible range", TextureFormat::rg32f, fewer(from->width_px()), fewer(from->height_px()));
    const RenderTarget target({&next}, nullptr);
    const Buffer uniforms = uniform_buffer("range block", block);
    program_.use();
    bind_uniform_blocks({&uniforms});
    bind_textures({from});
    draw_full_screen();
    range = std::move(next);
    from = &range;
    block.is_first = 0;
  } while (range.width_px() > 1 || range.height_px() > 1);
  return range;
}

}  // namespace inkbench
