// SPDX-License-Identifier: MIT
#include "pipeline/passes/picture/box_filter.h"

#include "pipeline/gl/framebuffer.h"

namespace inkbench {
namespace {

/// filter_block of shaders/box_filter.frag in std140.
struct FilterBlock {
  int left, bottom;
  int times;
  int channel;
  float gain;
  float low;
  float padding[2];
};

}  // namespace

BoxFilterPass::BoxFilterPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "box_filter.frag",
               {.samplers = {"buffer_map"}, .uniform_blocks = {{"filter_block", sizeof(FilterBlock)}}},
               generated) {}

void BoxFilterPass::run(const PictureView& view, const Texture& buffer, const ImageWindow& window, int times,
                        const ImageWindow& part, const Texture& picture) const {
  const RenderTarget target({&picture}, nullptr);
  const FilterBlock block{window.left, window.bottom, times, view.channel, view.gain, view.low, {}};
  const Buffer uniforms("filter block", bytes_of(std::span(&block, 1)));
  program_.use();
  bind_uniform_blocks({&uniforms});
  bind_textures({&buffer});
  draw_rectangle(part.left, part.bottom, part.width, part.height);
}

}  // namespace inkbench
