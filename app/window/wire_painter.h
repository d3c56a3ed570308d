// SPDX-License-Identifier: MIT
// The triangles of the scene's meshes, as they are drawn, as thin lines to lay over a picture. In: settings,
// and which part of a picture a tile shows. Out: a see-through texture of the tile's size. Of the window
// alone: no file has them.
#pragma once

#include "app/window/tile.h"
#include "pipeline/pipeline.h"

namespace inkbench {

/// Of a tile and of the picture that it shows a part of.
struct WireView {
  TilePlace place;
  int width_px = 1, height_px = 1;
  glm::vec4 colour{1.0F};
};

class WirePainter {
 public:
  /// Errors (input): the shader does not compile.
  WirePainter();

  /// Edges that are not hidden by the meshes themselves, one pixel wide at any zoom. Kept until something
  /// changes. Errors: as `Frame::draw_items`.
  const Texture& paint(const Frame& frame, const WireView& view);

  bool reload_if_changed() { return program_.reload_if_changed({}); }
  const std::string& shader_problem() const { return program_.problem(); }

 private:
  Texture run(const Frame& frame, const WireView& view) const;

  Program program_;
  Stage<Texture> tile_;
};

}  // namespace inkbench
