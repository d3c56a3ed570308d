// SPDX-License-Identifier: MIT
// Lines of surfaces as one view shows them, hidden parts included: what lies between extraction and curves.
// In: lines in the world. Out: their parts inside the view, in pixels, and where something may begin to cover
// them or cease to.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "pipeline/curves/curve.h"
#include "pipeline/curves/curve_view.h"

namespace inkbench {

struct LinePoint {
  glm::dvec3 world{0.0};
  glm::dvec3 pixel{0.0};  ///< `CurveView::to_pixel`.
  uint64_t place = 0;     ///< `Curve::places`.
  /// Why what covers the line may change here, if it may: `crossing`, `cusp` or `junction`.
  std::optional<CurveEnd> change;
};

/// Where between two points of the world lies what is seen at a share of the way between them in the image.
double along_in_world(const LinePoint& a, const LinePoint& b, double along_in_image);

/// What a step of a line, from one point to the next, lies on.
struct LineStep {
  uint32_t edge = kNone;  ///< Of the model's topology, of lines along edges.
  double across = 0.0;    ///< Of lines that follow: the face's height over its longest side, world units.
  static constexpr uint32_t kNone = ~0U;
};

struct ViewLine {
  CurveClass line_class = CurveClass::silhouette;
  int model = 0;           ///< Its place in the list of models.
  bool covers = false;     ///< Surfaces end at it as the eye sees them, so that it may cover others.
  bool follows = false;    ///< It takes what covers the nearest line that covers.
  bool is_drawn = true;    ///< Else it only covers.
  bool is_closed = false;  ///< Then the last point is the first again.
  CurveEnd start = CurveEnd::free, end = CurveEnd::free;
  std::vector<LinePoint> points;
  std::vector<LineStep> steps;  ///< One fewer than points.
};

/// The parts between the near and the far plane and inside the image with `kCurveMarginPx` around it. A
/// closed line that is cut starts at a cut. Of `line` what the world decides is given: no pixels.
void add_to_view(const ViewLine& line, const CurveView& view, std::vector<ViewLine>& lines);

}  // namespace inkbench
