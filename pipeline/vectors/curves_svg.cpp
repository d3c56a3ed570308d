// SPDX-License-Identifier: MIT
#include "pipeline/vectors/curves_svg.h"

#include <fmt/format.h>

#include "pipeline/base/stop.h"
#include "pipeline/strokes/curve_look.h"
#include "pipeline/vectors/fit_path.h"
#include "pipeline/vectors/svg_parts.h"

namespace inkbench {
namespace {

constexpr FitOptions kCurveFit{.error = 0.1};

std::string curve_element(const Curve& curve) {
  const CubicPath path = fit_path(curve.points, kCurveFit);
  const std::string data = path_data({&path, 1}, kPxDigits);
  if (data.empty()) return "";
  const std::string covered = curve.covered > 0 ? fmt::format(" data-covered=\"{}\"", curve.covered) : "";
  return fmt::format("<path{} d=\"{}\"/>\n", covered, data);
}

ClassAttributes curve_attributes(const StrokeClasses& classes) {
  ClassAttributes attributes;
  for (size_t i = 0; i < kCurveClasses; ++i)
    attributes.visible[i] = " stroke=\"" + svg_colour(classes[i].colour) + "\"";
  attributes.hidden = attributes.visible;
  attributes.hidden_group =
      fmt::format(" opacity=\"{}\" stroke-dasharray=\"{} {}\"", svg_number(kCoveredShare, 3),
                  svg_number(kCurveDashPx, 2), svg_number(kCurveGapPx, 2));
  return attributes;
}

}  // namespace

std::string curves_svg(const Curves& curves, bool with_hidden, const StrokeClasses& classes,
                       const VectorPage& page, const std::string& below) {
  std::vector<ClassItem> items;
  for (const Curve& curve : curves.curves) {
    stop_if_asked();
    if (curve.covered > 0 && !with_hidden) continue;
    items.push_back({curve.covered > 0, curve.curve_class, curve.object_id, curve_element(curve)});
  }
  std::string drawn = class_groups(items, curve_attributes(classes), page.object_names);
  if (!drawn.empty()) {
    drawn = fmt::format(
        "<g id=\"curves\" fill=\"none\" stroke-width=\"{}\" stroke-linecap=\"round\" "
        "stroke-linejoin=\"round\">\n{}</g>\n",
        svg_number(kCurveWidthPx, 2), drawn);
  }
  return svg_file(page, "", below + drawn);
}

}  // namespace inkbench
