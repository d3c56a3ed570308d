// SPDX-License-Identifier: MIT
// Drawing over those tiles of an image alone that have a line in reach (shaders/tiles.vert). In: a map of
// tiles. Out: fragments there and nowhere else; the rest of the target is cleared to 0.
#pragma once

#include <initializer_list>

#include "pipeline/gl/program.h"

namespace inkbench {

/// Tiles of 8 px along a side of the image.
inline int tiles_along(int side_px) {
  return (side_px + 7) / 8;
}

/// squares_block of shaders/tiles.vert in std140.
struct SquaresBlock {
  int width_px, height_px;
  int reach_px;
  int columns;
};
inline const UniformBlock kSquaresBlock{"squares_block", sizeof(SquaresBlock)};

/// Draws a program with the vertex shader tiles.vert. `reach_px`: how far from a pixel a line matters to it.
/// Samplers in the program's order, the tiles' map among them; blocks too, of which the last is added here.
void draw_over_tiles(const Texture& target, const Program& program, int reach_px,
                     std::initializer_list<const Texture*> maps, std::initializer_list<const Buffer*> blocks);

}  // namespace inkbench
