// SPDX-License-Identifier: MIT
// Drawing over those tiles of an image alone that matter: shaders/tiles.vert takes those that a map says,
// tiles_near_lines.vert those with a line in reach. Fragments are there and nowhere else; the rest of the
// target is cleared.
#pragma once

#include <glm/vec4.hpp>
#include <initializer_list>

#include "pipeline/gl/program.h"

namespace inkbench {

/// Tiles of 8 px along a side of the image.
inline int tiles_along(int side_px) {
  return (side_px + 7) / 8;
}

/// squares_block of shaders/lib/tile_point.glsl in std140.
struct SquaresBlock {
  int width_px, height_px;
  int reach_px;
  int columns;
};
inline const UniformBlock kSquaresBlock{"squares_block", sizeof(SquaresBlock)};

/// Draws a program with one of those vertex shaders. `reach_px`: how far from a pixel something matters to
/// it. Samplers in the program's order, the vertex shader's map among them; blocks too, of which the last is
/// added here. `elsewhere`: what the target has where nothing is drawn.
void draw_over_tiles(const Texture& target, const Program& program, int reach_px,
                     std::initializer_list<const Texture*> maps, std::initializer_list<const Buffer*> blocks,
                     const glm::vec4& elsewhere = glm::vec4(0.0F));

}  // namespace inkbench
