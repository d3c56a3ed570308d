// SPDX-License-Identifier: MIT
#include "pipeline/passes/placing/tiles.h"

#include <vector>

#include "pipeline/gl/framebuffer.h"

namespace inkbench {
void draw_over_tiles(const Texture& target, const Program& program, int reach_px,
                     std::initializer_list<const Texture*> maps, std::initializer_list<const Buffer*> blocks,
                     const glm::vec4& elsewhere) {
  const int columns = tiles_along(target.width_px()), rows = tiles_along(target.height_px());
  const SquaresBlock block{target.width_px(), target.height_px(), reach_px, columns};
  const Buffer squares = uniform_buffer("squares block", block);
  const RenderTarget drawn({&target}, nullptr);
  glClearBufferfv(GL_COLOR, 0, &elsewhere.x);
  program.use();
  std::vector<const Buffer*> all(blocks);
  all.push_back(&squares);
  bind_uniform_blocks(all);
  bind_textures(maps);
  draw_points(columns * rows);
}

}  // namespace inkbench
