// SPDX-License-Identifier: MIT
// A picture, or a part of it, at the size at which it stands in the window. In: a picture on the GPU and
// which part of it. Out: a texture to draw one to one, kept until something changes, so that frames in which
// only the mouse moves cost nothing here.
#pragma once

#include <map>
#include <string>

#include "pipeline/flow/pass_observer.h"
#include "pipeline/flow/stage.h"
#include "pipeline/gl/program.h"
#include "pipeline/gl/texture.h"

namespace inkbench {

/// The picture's point under the tile's top left corner, and picture pixels per window pixel. Both in pixels,
/// x to the right and y down.
struct TilePlace {
  double left = 0.0, top = 0.0;
  double step = 1.0;
  bool operator==(const TilePlace&) const = default;
};

/// Lines to lay over a picture of the same size: rgba8, clear where there is none. `veil`: how much the
/// picture fades to white below them, 0 to 1.
struct TileOverlay {
  const Texture* texture = nullptr;
  Key key;
  float veil = 0.0F;
};

class TilePainter {
 public:
  /// Errors (input): the shader does not compile.
  TilePainter();

  /// The part of `picture` that a tile of that size shows; see-through where there is no picture. Each pixel
  /// is the mean of what it covers, or, when magnified, the nearest picture pixel. `slot` names the tile.
  const Texture& paint(const std::string& slot, const Texture& picture, const Key& picture_key,
                       const TilePlace& place, int width_px, int height_px, const TileOverlay& overlay = {});

  void observe(PassObserver* observer) { observer_ = observer; }
  bool reload_if_changed() { return program_.reload_if_changed({}); }
  const std::string& shader_problem() const { return program_.problem(); }

 private:
  Texture run(const Texture& picture, const TilePlace& place, int width_px, int height_px,
              const TileOverlay& overlay) const;

  Program program_;
  std::map<std::string, Stage<Texture>> tiles_;
  PassObserver* observer_ = nullptr;
};

}  // namespace inkbench
