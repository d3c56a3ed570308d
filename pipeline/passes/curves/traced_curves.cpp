// SPDX-License-Identifier: MIT
#include "pipeline/passes/curves/traced_curves.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>

#include "pipeline/curves/trace_lines.h"
#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/placing/connect.h"
#include "pipeline/passes/placing/placed_lines.h"

namespace inkbench {
namespace {

CurveClass curve_class_of(EdgeClass edge_class) {
  switch (edge_class) {
    case EdgeClass::object:
      return CurveClass::object;
    case EdgeClass::silhouette:
      return CurveClass::silhouette;
    case EdgeClass::crease:
      return CurveClass::crease;
    case EdgeClass::shadow:
      return CurveClass::shadow;
    case EdgeClass::material:
      return CurveClass::material;
    case EdgeClass::none:
    case EdgeClass::normal:
      break;
  }
  return CurveClass::normal;
}

/// One pixel of the maps.
struct SeenPixel {
  float depth = 1.0F;
  int object_id = 0;
};

/// The nearest of those up to `reach` pixels away, or the farthest.
template <class IsBetter>
SeenPixel best_around(const SeenMaps& seen, int x, int y, int reach, const IsBetter& is_better) {
  SeenPixel best{seen.depth.at(x, y), static_cast<int>(std::lround(seen.object_id.at(x, y)))};
  for (int v = std::max(y - reach, 0); v <= std::min(y + reach, seen.depth.height_px - 1); ++v) {
    for (int u = std::max(x - reach, 0); u <= std::min(x + reach, seen.depth.width_px - 1); ++u) {
      if (is_better(seen.depth.at(u, v), best.depth))
        best = {seen.depth.at(u, v), static_cast<int>(std::lround(seen.object_id.at(u, v)))};
    }
  }
  return best;
}

Behind behind_of(const SeenPixel& nearest, const SeenPixel& farthest) {
  if (nearest.object_id == 0) return Behind::unknown;
  if (farthest.object_id == 0) return Behind::nothing;
  return farthest.object_id == nearest.object_id ? Behind::same_object : Behind::other_object;
}

LinePixel line_pixel(const PlacedLine& line, const SeenMaps& seen, float far, int x, int y) {
  const SeenPixel nearest = best_around(seen, x, y, 1, std::less<>());
  const SeenPixel farthest = best_around(seen, x, y, 2, std::greater<>());
  return {.x = x,
          .y = y,
          .offset = {line.offset_x, -line.offset_y},
          .curve_class = curve_class_of(line.line_class),
          .object_id = nearest.object_id,
          .depth = nearest.object_id == 0 ? 0.0F : nearest.depth * far,
          .behind = behind_of(nearest, farthest)};
}

}  // namespace

LinePixels line_pixels_of(const Picture& placed, const SeenMaps& seen, float far) {
  assert(placed.width_px == seen.depth.width_px && placed.height_px == seen.object_id.height_px);
  LinePixels lines{placed.width_px, placed.height_px, {}};
  for (int y = 0; y < placed.height_px; ++y) {
    for (int x = 0; x < placed.width_px; ++x) {
      const PlacedLine line = placed_at(placed, x, y);
      if (line.line_class != EdgeClass::none) lines.pixels.push_back(line_pixel(line, seen, far, x, y));
    }
  }
  return lines;
}

const PassKind& TracedCurvesPass::kind() {
  static const PassKind kKind = describe_pass<TracedCurvesPass>(
      "traced_curves", 8, {}, part<&Settings::curves, &CurvesParams::image_smoothing>(),
      part<&Settings::camera, &CameraParams::far>(), WindowInput{}, value_of<ConnectPass>(),
      value_of<GBufferPass>());
  return kKind;
}

Curves TracedCurvesPass::run(float reach_px, float far, const ImageWindow& window, const Texture& placed,
                             const GBuffer& gbuffer) const {
  const SeenMaps seen{gbuffer.normal_and_depth.read(3, 1), gbuffer.object_id.read(0, 1)};
  Curves curves = trace_lines(line_pixels_of(placed.read_picture(), seen, far), reach_px);
  const glm::vec2 corner(window.left, window.whole_height - window.bottom - window.height);
  for (Curve& curve : curves.curves) {
    for (glm::vec2& point : curve.points) point += corner;
  }
  curves.width_px = window.whole_width;
  curves.height_px = window.whole_height;
  return curves;
}

}  // namespace inkbench
