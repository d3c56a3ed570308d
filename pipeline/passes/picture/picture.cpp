// SPDX-License-Identifier: MIT
#include "pipeline/passes/picture/picture.h"

#include "pipeline/gl/framebuffer.h"

namespace inkbench {
namespace {

/// picture_block of shaders/picture.frag in std140.
struct PictureBlock {
  float gain;
  int channel;
  float low;
  int padding;
};

}  // namespace

PicturePass::PicturePass(const GeneratedSources& generated)
    : program_("full_screen.vert", "picture.frag",
               {.samplers = {"buffer_map"}, .uniform_blocks = {{"picture_block", sizeof(PictureBlock)}}},
               generated) {}

Texture PicturePass::run(const PictureView& view, const Texture& buffer) const {
  Texture picture("picture", TextureFormat::rgba8, buffer.width_px(), buffer.height_px());
  const RenderTarget target({&picture}, nullptr);
  const PictureBlock block{view.gain, view.channel, view.low, 0};
  const Buffer uniforms("picture block", bytes_of(std::span(&block, 1)));
  program_.use();
  bind_uniform_blocks({&uniforms});
  bind_textures({&buffer});
  draw_full_screen();
  return picture;
}

}  // namespace inkbench
