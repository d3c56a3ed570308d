// SPDX-License-Identifier: MIT
#include "app/workbench/sample_stroke.h"

#include <cmath>
#include <numbers>

#include "pipeline/strokes/make_strokes.h"

namespace inkbench {
namespace {

constexpr float kMargin = 0.04F;  ///< Of the width, left free on both sides.
constexpr float kBend = 0.16F;    ///< Of the height.

Curve wave(float width_px, float height_px) {
  constexpr int kSteps = 96;
  Curve curve;
  for (int i = 0; i <= kSteps; ++i) {
    const float share = static_cast<float>(i) / kSteps;
    const float bend = std::sin(2.0F * std::numbers::pi_v<float> * share);
    curve.points.emplace_back(width_px * (kMargin + (1.0F - 2.0F * kMargin) * share),
                              height_px * (0.5F - kBend * bend));
    curve.depths.push_back(0.0F);
    curve.places.push_back(static_cast<uint64_t>(i) + 1);
  }
  return curve;
}

}  // namespace

Strokes sample_stroke(const Settings& settings, float width_px, float height_px) {
  Curves curves{static_cast<int>(width_px), static_cast<int>(height_px), {wave(width_px, height_px)}, {}};
  StrokeParams style = settings.stroke;
  style.shadow_width = style.depth_taper = 0.0F;
  style.shortest = 0.0F;
  if (style.unit == WidthUnit::world) style.unit = WidthUnit::px;
  return make_strokes(curves, style, settings.stroke_classes, {.height_px = settings.image.height});
}

}  // namespace inkbench
