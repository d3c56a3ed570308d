// SPDX-License-Identifier: MIT
#include "pipeline/passes/curves/curves.h"

#include <algorithm>

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/lines/reference.h"

namespace inkbench {
namespace {

CurveClass curve_class_of(LineClass line_class) {
  const auto found = std::find(kCurveClassNames.begin(), kCurveClassNames.end(), name_of(line_class));
  return static_cast<CurveClass>(found - kCurveClassNames.begin());
}

}  // namespace

const PassKind& CurvesPass::kind() {
  static const PassKind kKind = describe_pass<CurvesPass>("curves", 1, {}, value_of<ReferencePass>());
  return kKind;
}

Curves CurvesPass::run(const ReferenceLines& lines) const {
  Curves curves{lines.width_px, lines.height_px, {}, {}};
  for (const Polyline& line : lines.polylines) {
    if (line.line_class == LineClass::object) continue;  // steps between pixels
    Curve curve{.curve_class = curve_class_of(line.line_class),
                .object_id = line.object_id,
                .chain = static_cast<uint32_t>(curves.curves.size()),
                .points = line.points};
    if (curve.is_closed()) curve.start = curve.end = CurveEnd::closed;
    curve.depths.assign(curve.points.size(), 0.0F);
    curve.places.assign(curve.points.size(), 0);
    curves.curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace inkbench
