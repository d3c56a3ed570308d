// SPDX-License-Identifier: MIT
// The painted marks as a clear picture to lay over others. In: the document's marks, a camera and a size.
// Out: a texture, made again when they change.
#pragma once

#include <optional>

#include "app/workbench/painted_marks.h"
#include "pipeline/gl/texture.h"

namespace inkbench {

/// Red, green, blue and alpha of a mark on the screen, 0 to 255.
inline constexpr uint8_t kMarkAlpha = 120;
struct MarkColour {
  uint8_t red = 0, green = 0, blue = 0;
};
inline constexpr MarkColour kWantedMark{235, 30, 40}, kUnwantedMark{40, 90, 255};

class MarkOverlay {
 public:
  /// Null where that camera has no marks of that size; holds until the next call. Errors (work): as
  /// `texture_of`.
  const Texture* find(const PaintedMarks& marks, const CameraParams& camera, int width_px, int height_px);

 private:
  std::optional<Texture> texture_;
  int width_px_ = 0, height_px_ = 0;
  std::string runs_;  ///< That the texture shows.
};

}  // namespace inkbench
