// SPDX-License-Identifier: MIT
// Lines one pixel wide, as plain data: what curves are traced from, whoever found the lines.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "pipeline/curves/curve.h"

namespace inkbench {

struct LinePixel {
  int x = 0, y = 0;        ///< Row 0 on top.
  glm::vec2 offset{0.0F};  ///< From the pixel's centre to the line, px, y down; at most half each way.
  CurveClass curve_class = CurveClass::silhouette;
  int object_id = 0;   ///< As in the object-id buffer; 0: none known.
  float depth = 0.0F;  ///< Distance along the view axis; 0: none known.
  Behind behind = Behind::unknown;

  glm::vec2 centre() const { return {static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F}; }
  glm::vec2 point() const { return centre() + offset; }
};

struct LinePixels {
  int width_px = 0, height_px = 0;
  std::vector<LinePixel> pixels;  ///< Each once, row by row from the top, in order of x.
};

}  // namespace inkbench
