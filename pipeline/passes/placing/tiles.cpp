// SPDX-License-Identifier: MIT
#include "pipeline/passes/placing/tiles.h"

#include <array>
#include <vector>

#include "pipeline/gl/framebuffer.h"

namespace inkbench {
namespace {

/// Of 16 px, along a side of the image.
int squares_along(int side_px) {
  return (side_px + 15) / 16;
}

}  // namespace

void draw_over_tiles(const Texture& target, const Program& program, int reach_px,
                     std::initializer_list<const Texture*> maps,
                     std::initializer_list<const Buffer*> blocks) {
  const int columns = squares_along(target.width_px()), rows = squares_along(target.height_px());
  const SquaresBlock block{target.width_px(), target.height_px(), reach_px, columns};
  const Buffer squares("squares block", bytes_of(std::span<const SquaresBlock>(&block, 1)));
  const RenderTarget drawn({&target}, nullptr);
  constexpr std::array kNothing{0.0F, 0.0F, 0.0F, 0.0F};
  glClearBufferfv(GL_COLOR, 0, kNothing.data());
  program.use();
  std::vector<const Buffer*> all(blocks);
  all.push_back(&squares);
  bind_uniform_blocks(all);
  bind_textures(maps);
  draw_strips(4, columns * rows);
}

}  // namespace inkbench
