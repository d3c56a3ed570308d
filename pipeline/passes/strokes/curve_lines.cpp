// SPDX-License-Identifier: MIT
#include "pipeline/passes/strokes/curve_lines.h"

#include <glm/geometric.hpp>

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/curves/curves.h"
#include "pipeline/strokes/curve_look.h"
#include "pipeline/strokes/dashes.h"

namespace inkbench {
namespace {

constexpr BufferInfo kCurves{.name = "curves",
                             .help =
                                 "Curves of the view in their classes' colours; covered ones dashed, "
                                 "where strokes draw them.",
                             .channels = 4,
                             .shown_as = ShownAs::colour,
                             .is_supersampled = true};

Stroke line_of(const Curve& curve) {
  Stroke line{.object_id = curve.object_id, .covered = curve.covered, .is_closed = curve.is_closed()};
  float along = 0.0F;
  for (size_t i = 0; i < curve.points.size(); ++i) {
    if (i > 0) along += glm::distance(curve.points[i - 1], curve.points[i]);
    line.points.push_back({curve.points[i], 0.5F * kCurveWidthPx, along, curve.curve_class});
  }
  line.end_px = along;
  return line;
}

struct LineBrushInput {
  LineBrushInput bind(Flow&) const { return *this; }
  static std::vector<PassInput> told() { return {}; }
  BrushParams get(const FrameState&) const { return {.hidden_opacity = kCoveredShare}; }
  void fold(KeyBuilder&, const FrameState&) const {}
};

struct CurveLookInput {
  CurveLookInput bind(Flow&) const { return *this; }
  static std::vector<PassInput> told() { return {{StrokeParams::description().group}}; }
  StrokeLook get(const FrameState& frame) const {
    StrokeLook look{.colour = StrokeColour::by_class};
    for (size_t i = 0; i < kCurveClasses; ++i)
      look.of_class[i] = glm::vec4(frame.settings.stroke_classes[i].colour, 1.0F);
    return look;
  }
  void fold(KeyBuilder& key, const FrameState& frame) const {
    const StrokeLook look = get(frame);
    key.add_bytes({reinterpret_cast<const uint8_t*>(look.of_class.data()), sizeof look.of_class});
  }
};

}  // namespace

constinit const BufferName BufferName::curves{kCurves};

const PassKind& CurveLinesPass::kind() {
  static const PassKind kKind = describe_pass<CurveLinesPass>(
      "curve_lines", 1, {}, value_of<CurvesPass>(), part<&Settings::stroke, &StrokeParams::hidden>());
  return kKind;
}

Strokes CurveLinesPass::run(const Curves& curves, bool with_hidden) const {
  Strokes lines{curves.width_px, curves.height_px, {}, {}};
  for (const Curve& curve : curves.curves) {
    if (curve.covered > 0 && !with_hidden) continue;
    const Stroke line = line_of(curve);
    if (!(line.end_px > 0.0F)) continue;
    if (curve.covered == 0) {
      lines.strokes.push_back(line);
      continue;
    }
    for (Stroke& dash : dashes_of(line, kCurveDashPx, kCurveGapPx)) lines.strokes.push_back(std::move(dash));
  }
  return lines;
}

const PassKind& CurvePaint::kind() {
  static const PassKind kKind = describe_pass<CurvePaint>("curve_paint", 3, {}, LineBrushInput{},
                                                          WindowInput{}, value_of<CurveLinesPass>());
  return kKind;
}

const PassKind& CurveColours::kind() {
  static const PassKind kKind = describe_pass<CurveColours>("curve_colours", 1, {shows(BufferName::curves)},
                                                            CurveLookInput{}, value_of<CurvePaint>());
  return kKind;
}

}  // namespace inkbench
