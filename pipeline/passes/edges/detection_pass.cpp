// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/detection_pass.h"

#include "pipeline/gl/framebuffer.h"

namespace inkbench {

Texture detection_target(const std::string& label, const Texture& like) {
  return {label, TextureFormat::rg32f, like.width_px(), like.height_px()};
}

Buffer weak_block(float weak) {
  EdgesParams edges;
  edges.weak = weak;
  return block_buffer(edges);
}

void draw_over(const Texture& target, const Program& program, std::initializer_list<const Texture*> maps,
               std::initializer_list<const Buffer*> blocks) {
  const RenderTarget drawn({&target}, nullptr);
  program.use();
  bind_uniform_blocks(blocks);
  bind_textures(maps);
  draw_full_screen();
}

}  // namespace inkbench
