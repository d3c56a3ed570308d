// SPDX-License-Identifier: MIT
#include "pipeline/passes/strokes/stroke_tiles.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "pipeline/passes/placing/tiles.h"

namespace inkbench {
namespace {

constexpr float kStepPx = 4.0F;    ///< Along a segment.
constexpr float kMarginPx = 2.0F;  ///< Edges are antialiased.
constexpr float kTilePx = 8.0F;

/// Tiles that a square about a place touches; from the window's lower left corner.
void mark_square(Image& tiles, glm::vec2 middle, float half_px) {
  const auto tile = [](float place, int count) {
    return static_cast<int>(std::clamp(std::floor(place / kTilePx), -1.0F, static_cast<float>(count)));
  };
  const int left = std::max(tile(middle.x - half_px, tiles.width_px), 0);
  const int right = std::min(tile(middle.x + half_px, tiles.width_px), tiles.width_px - 1);
  const int low = std::max(tile(middle.y - half_px, tiles.height_px), 0);
  const int high = std::min(tile(middle.y + half_px, tiles.height_px), tiles.height_px - 1);
  for (int y = low; y <= high; ++y)
    for (int x = left; x <= right; ++x) tiles.at(x, tiles.height_px - 1 - y) = 1.0F;
}

}  // namespace

Image stroke_tiles(const Strokes& strokes, const ImageWindow& window) {
  Image tiles(tiles_along(window.width), tiles_along(window.height), 1);
  const auto in_window = [&](glm::vec2 at) {
    return glm::vec2(at.x, window.whole_size_px().y - at.y) - window.corner_px();
  };
  for (const Stroke& stroke : strokes.strokes) {
    for (size_t i = 1; i < stroke.points.size(); ++i) {
      const StrokePoint& from = stroke.points[i - 1];
      const StrokePoint& to = stroke.points[i];
      const float half_px = std::max(from.radius_px, to.radius_px) + kMarginPx + kStepPx / 2.0F;
      const int steps = 1 + static_cast<int>(glm::distance(from.at, to.at) / kStepPx);
      for (int step = 0; step <= steps; ++step)
        mark_square(tiles,
                    in_window(glm::mix(from.at, to.at, static_cast<float>(step) / static_cast<float>(steps))),
                    half_px);
    }
  }
  return tiles;
}

}  // namespace inkbench
