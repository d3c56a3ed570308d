#include "app/window/tile.h"

#include <fmt/format.h>

#include "pipeline/gl/framebuffer.h"

namespace inkbench {
namespace {

/// tile_block of shaders/tile.frag in std140.
struct TileBlock {
  float left, top, step;
  int tile_height_px;
};

}  // namespace

TilePainter::TilePainter()
    : program_("full_screen.vert", "tile.frag",
               {.samplers = {"picture_map"}, .uniform_blocks = {"tile_block"}}, {}) {}

Texture TilePainter::run(const Texture& picture, const TilePlace& place, int width_px, int height_px) const {
  Texture tile("tile", TextureFormat::rgba8, width_px, height_px);
  const RenderTarget target({&tile}, nullptr);
  const TileBlock block{static_cast<float>(place.left), static_cast<float>(place.top),
                        static_cast<float>(place.step), height_px};
  const Buffer uniforms("tile block", bytes_of(std::span(&block, 1)));
  program_.use();
  bind_uniform_blocks({&uniforms});
  bind_textures({&picture});
  draw_full_screen();
  return tile;
}

const Texture& TilePainter::paint(const std::string& slot, const Texture& picture, const Key& picture_key,
                                  const TilePlace& place, int width_px, int height_px) {
  const Key key =
      KeyBuilder()
          .add("tile")
          .add(program_.key())
          .add(picture_key)
          .add(fmt::format("{} {} {} {} {}", place.left, place.top, place.step, width_px, height_px))
          .key();
  return tiles_[slot].get(key, [&] {
    const PassScope scope(observer_, "tiles");
    return run(picture, place, width_px, height_px);
  });
}

}  // namespace inkbench
