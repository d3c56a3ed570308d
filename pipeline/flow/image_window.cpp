// SPDX-License-Identifier: MIT
#include "pipeline/flow/image_window.h"

#include <fmt/format.h>

#include <algorithm>

namespace inkbench {

ImageWindow whole_image(const ImageParams& image) {
  return {0, 0, image.width, image.height, image.width, image.height, std::nullopt};
}

std::string key_text(const ImageWindow& window) {
  std::string text = fmt::format("{} x {}", window.width, window.height);
  if (!window.is_whole())
    text += fmt::format(" at {} {} of {} x {}", window.left, window.bottom, window.whole_width,
                        window.whole_height);
  if (window.visible_range)
    text += fmt::format(", sees {} to {}", window.visible_range->x, window.visible_range->y);
  return text;
}

ImageWindow projected_window(const ImageWindow& window, int largest_viewport_px) {
  if (std::max(window.whole_width, window.whole_height) > largest_viewport_px) return window;
  return {0,           0, window.whole_width, window.whole_height, window.whole_width, window.whole_height,
          std::nullopt};
}

glm::mat4 projection_matrix(const CameraParams& camera, const ImageWindow& window) {
  const glm::mat4 whole = projection_matrix(camera, window.whole_aspect());
  if (window.is_whole()) return whole;
  const glm::dvec2 part(window.width, window.height), all(window.whole_size_px());
  const glm::dvec2 scale = all / part, shift = (all - 2.0 * glm::dvec2(window.corner_px()) - part) / part;
  glm::dmat4 crop(1.0);
  for (int axis = 0; axis < 2; ++axis) {
    crop[axis][axis] = scale[axis];
    crop[3][axis] = shift[axis];
  }
  return glm::mat4(crop * glm::dmat4(whole));
}

}  // namespace inkbench
