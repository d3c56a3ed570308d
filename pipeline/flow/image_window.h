// SPDX-License-Identifier: MIT
// Which part of the image a frame draws: all of it, or one tile of an image that is drawn in tiles. In:
// pixels of the whole image, whose size the frame's settings have. Out: what the camera projects onto the
// part.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "pipeline/settings/camera.h"
#include "pipeline/settings/image_params.h"

namespace inkbench {

/// A rectangle of the whole image, px, from the lower left corner as in textures.
struct ImageWindow {
  int left = 0, bottom = 0;
  int width = 0, height = 0;
  int whole_width = 0, whole_height = 0;
  /// Nearest and farthest visible distance of the whole image, as `VisibleRangePass` gives them; none where
  /// the part is to find its own.
  std::optional<glm::vec2> visible_range;

  bool is_whole() const { return width == whole_width && height == whole_height; }
  float whole_aspect() const { return static_cast<float>(whole_width) / static_cast<float>(whole_height); }
  glm::vec2 corner_px() const { return {left, bottom}; }
  glm::vec2 whole_size_px() const { return {whole_width, whole_height}; }
  /// The whole image's middle, in px from the part's lower left corner.
  glm::vec2 middle_px() const { return 0.5F * whole_size_px() - corner_px(); }
};

ImageWindow whole_image(const ImageParams& image);

/// What keys fold of it.
std::string key_text(const ImageWindow& window);

/// What to project onto, so that the part's pixels are the whole's to the bit: all of the image, of which a
/// viewport that reaches beyond the part shows the part; where no viewport is as large, the part itself.
ImageWindow projected_window(const ImageWindow& window, int largest_viewport_px);

/// Eye space to the part's clip space.
glm::mat4 projection_matrix(const CameraParams& camera, const ImageWindow& window);

}  // namespace inkbench
