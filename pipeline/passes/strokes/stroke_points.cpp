// SPDX-License-Identifier: MIT
#include "pipeline/passes/strokes/stroke_points.h"

#include "pipeline/strokes/coherent_noise.h"

namespace inkbench {
namespace {

glm::vec4 place_of(const StrokePoint& point, float shift_px) {
  return {point.at, point.radius_px, point.along_px + shift_px};
}

glm::vec4 paint_of(const Stroke& stroke, const StrokePoint& point, bool starts_segment) {
  const int flags = (starts_segment ? kSegmentFlag : 0) | (stroke.covered > 0 ? kHiddenFlag : 0) |
                    (stroke.is_closed ? kClosedFlag : 0);
  const uint32_t seed = hashed(stroke.number, static_cast<uint32_t>(stroke.pass)) & 0xFFFFFFU;
  return {static_cast<float>(seed), static_cast<float>(static_cast<int>(point.curve_class) + 16 * flags),
          stroke.start_px, stroke.end_px};
}

/// What lies before the first or after the last point: nothing, or on a closed stroke its other end.
DrawnPoint neighbour(const Stroke& stroke, int number) {
  const auto count = static_cast<int>(stroke.points.size()) - 1;
  DrawnPoint none{glm::vec4(0.0F, 0.0F, -1.0F, 0.0F), glm::vec4(0.0F)};
  if (!stroke.is_closed || count < 3) return none;
  const float round = stroke.points.back().along_px - stroke.points.front().along_px;
  none.place = place_of(stroke.points[(number + count) % count], number < 0 ? -round : round);
  return none;
}

}  // namespace

std::vector<DrawnPoint> drawn_points(const Strokes& strokes) {
  std::vector<DrawnPoint> points;
  for (const Stroke& stroke : strokes.strokes) {
    const auto count = static_cast<int>(stroke.points.size());
    for (int i = -kNeighbours; i < count + kNeighbours; ++i) {
      if (i < 0 || i >= count) {
        points.push_back(neighbour(stroke, i < 0 ? i : i + 1 - count));
        continue;
      }
      const StrokePoint& point = stroke.points[i];
      points.push_back({place_of(point, 0.0F), paint_of(stroke, point, i + 1 < count)});
    }
  }
  return points;
}

}  // namespace inkbench
