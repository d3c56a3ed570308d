// SPDX-License-Identifier: MIT
// Pictures by `image.supersample`: drawn so many times as wide and as high, tile by tile, and filtered down.
// In: a frame's settings. Out: the picture of one buffer. Everything is found and drawn again at the large
// size, but for curves and strokes, which are those of the picture's own size; widths, tapers and shortest
// lengths of lines stay in the picture's own pixels.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pipeline/passes/picture/box_filter.h"
#include "pipeline/pipeline.h"

namespace inkbench {

/// What is drawn for a picture of `times` the size: the same lines in more pixels. Its size is the product's.
Settings enlarged(const Settings& settings, int times);

/// A picture's tiles and how far around each of them is drawn as well, so that none shows a seam.
struct TilePlan {
  int times = 1;
  int margin_px = 0;  ///< Of the large image.
  int tile_width = 0, tile_height = 0;
  std::string why_whole;  ///< Why there is one tile whatever its size; empty where there may be more.

  /// Each tile in the picture's pixels, rows from the bottom.
  std::vector<ImageWindow> tiles(const ImageParams& picture) const;
  /// What of the large image is drawn for a tile.
  ImageWindow drawn_for(const ImageWindow& tile) const;
};

/// Tiles whose drawn parts are at most `most_px` a side as far as lines are not wider than that. Lines that
/// are thinned, or looked at as a whole (hysteresis, shortest length, taper), need the whole image at once.
/// `visible`: nearest and farthest distance.
TilePlan plan_tiles(const Settings& settings, BufferName buffer, const glm::vec2& visible, int most_px);

class Supersampler {
 public:
  /// With what another pipeline holds of meshes.
  Supersampler(std::shared_ptr<LineFinder> finder, std::shared_ptr<MeshStore> meshes);

  /// Out: rgba8, H x W: means of display values. `visible`: of the settings' own image; `given`: values for
  /// the large one. Errors (input): one
  /// part is larger than the renderer draws; as the passes; (work): there is too little memory for it.
  Texture draw(const Settings& settings, const glm::vec2& visible, const std::vector<GivenValue>& given,
               BufferName buffer, const PictureView& view, const BoxFilterPass& filter, int most_tile_px);

  void forget_results() { pipeline_.forget_results(); }
  bool reload_changed_shaders() { return pipeline_.reload_changed_shaders(); }

 private:
  void check_part(const ImageWindow& window, const TilePlan& plan);

  Pipeline pipeline_;  ///< Its own, so that the frame's passes keep what they hold.
};

/// Does the buffer's picture follow `image.supersample` here?
inline bool is_supersampled(const Settings& settings, BufferName buffer) {
  return settings.image.supersample > 1 && buffer.info().is_supersampled;
}

}  // namespace inkbench
