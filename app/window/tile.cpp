// SPDX-License-Identifier: MIT
#include "app/window/tile.h"

#include <fmt/format.h>

#include <array>

#include "pipeline/gl/framebuffer.h"

namespace inkbench {
namespace {

/// tile_block of shaders/tile.frag in std140.
struct TileBlock {
  float left, top, step;
  int tile_height_px;
  float veil;  ///< Below 0: there is no overlay.
  std::array<float, 3> padding{};
};

}  // namespace

TilePainter::TilePainter()
    : program_(
          "full_screen.vert", "tile.frag",
          {.samplers = {"picture_map", "overlay_map"}, .uniform_blocks = {{"tile_block", sizeof(TileBlock)}}},
          {}) {}

Texture TilePainter::run(const Texture& picture, const TilePlace& place, int width_px, int height_px,
                         const TileOverlay& overlay) const {
  Texture tile("tile", TextureFormat::rgba8, width_px, height_px);
  const RenderTarget target({&tile}, nullptr);
  const TileBlock block{static_cast<float>(place.left),
                        static_cast<float>(place.top),
                        static_cast<float>(place.step),
                        height_px,
                        overlay.texture != nullptr ? overlay.veil : -1.0F,
                        {}};
  const Buffer uniforms("tile block", bytes_of(std::span(&block, 1)));
  program_.use();
  bind_uniform_blocks({&uniforms});
  bind_textures({&picture, overlay.texture != nullptr ? overlay.texture : &picture});
  draw_full_screen();
  return tile;
}

const Texture& TilePainter::paint(const std::string& slot, const Texture& picture, const Key& picture_key,
                                  const TilePlace& place, int width_px, int height_px,
                                  const TileOverlay& overlay) {
  const Key key =
      KeyBuilder()
          .add("tile")
          .add(program_.key())
          .add(picture_key)
          .add(overlay.key)
          .add(fmt::format("{} {} {} {} {}", place.left, place.top, place.step, width_px, height_px))
          .key();
  return tiles_[slot].get(key, [&] {
    const PassScope scope(observer_, "tiles");
    return run(picture, place, width_px, height_px, overlay);
  });
}

}  // namespace inkbench
