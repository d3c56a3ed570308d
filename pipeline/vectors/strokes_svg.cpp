// SPDX-License-Identifier: MIT
#include "pipeline/vectors/strokes_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <map>
#include <tuple>

#include "pipeline/base/stop.h"
#include "pipeline/vectors/fit_path.h"
#include "pipeline/vectors/stroke_outline.h"
#include "pipeline/vectors/svg_parts.h"

namespace inkbench {
namespace {

/// Arcs of polygons and the rounding of coordinates are the rest of `kOutlineErrorPx`.
constexpr FitOptions kOutlineFit{.error = 0.05, .corner_deg = 40.0, .corner_reach = 0.15};
constexpr float kShadingSteps = 15.0F, kMaterialSteps = 255.0F;

bool is_of_surface(StrokeColour colour) {
  return colour == StrokeColour::material || colour == StrokeColour::shading;
}

/// Of the step that begins at that point of a stroke.
std::string step_colour(const Stroke& stroke, size_t step, const StrokeInk& ink) {
  const StrokePoint& point = stroke.points[step];
  if (ink.stroke.colour == StrokeColour::ink) return svg_colour(ink.ink.colour);
  if (!is_of_surface(ink.stroke.colour))
    return svg_colour(ink.classes[static_cast<size_t>(point.curve_class)].colour);
  const glm::vec3 below = ink.surface.at(0.5F * (point.at + stroke.points[step + 1].at));
  const float steps = ink.stroke.colour == StrokeColour::shading ? kShadingSteps : kMaterialSteps;
  return svg_colour(glm::round(below * (1.0F - ink.stroke.darken) * steps) / steps);
}

/// What is filled as one: hidden, class, object, colour.
using Fill = std::tuple<bool, CurveClass, int, std::string>;
using Fills = std::map<Fill, std::vector<StrokePart>>;

/// A stroke in parts of one class and colour each.
void add_parts(const Stroke& stroke, const StrokeInk& ink, Fills& fills) {
  for (size_t step = 0, first = 0; step + 1 < stroke.points.size(); ++step) {
    const Fill fill{stroke.covered > 0, stroke.points[step].curve_class, stroke.object_id,
                    step_colour(stroke, step, ink)};
    const bool ends = step + 2 == stroke.points.size() ||
                      stroke.points[step + 1].curve_class != stroke.points[step].curve_class ||
                      step_colour(stroke, step + 1, ink) != std::get<std::string>(fill);
    if (!ends) continue;
    fills[fill].push_back({&stroke, first, step + 1});
    first = step + 1;
  }
}

/// The classes' opacities as shares of the largest one, which all strokes have together: what is opaque in
/// its group hides what lies below, so that nothing shows through.
struct Opacities {
  float of_all = 0.0F;
  std::array<float, kCurveClasses> shares{};
};

Opacities opacities(const Fills& fills, const StrokeInk& ink) {
  Opacities result;
  for (const auto& [fill, parts] : fills)
    result.of_all =
        std::max(result.of_all, ink.classes[static_cast<size_t>(std::get<CurveClass>(fill))].opacity);
  for (size_t i = 0; i < kCurveClasses; ++i)
    result.shares[i] = result.of_all > 0.0F ? std::min(1.0F, ink.classes[i].opacity / result.of_all) : 0.0F;
  result.of_all *= ink.stroke.opacity;
  return result;
}

/// The outlines of fills, class by class from the first on: of two classes through which one can see the
/// earlier one has the places to itself where it hides as much.
class OutlineMaker {
 public:
  explicit OutlineMaker(const Opacities& opacities) : shares_(opacities.shares) {}

  Outline outline(const Fill& fill, const std::vector<StrokePart>& parts) {
    const auto [is_hidden, curve_class, object_id, colour] = fill;
    const size_t number = static_cast<size_t>(curve_class);
    Outline outline = stroke_outline(parts);
    if (is_hidden || shares_[number] >= 1.0F) return outline;
    for (size_t earlier = 0; earlier < number; ++earlier) {
      if (shares_[earlier] >= shares_[number] && shares_[earlier] < 1.0F)
        outline = without(outline, taken_[earlier]);
    }
    taken_[number].insert(taken_[number].end(), outline.begin(), outline.end());
    return outline;
  }

 private:
  std::array<float, kCurveClasses> shares_;
  std::array<Outline, kCurveClasses> taken_;
};

std::string outline_elements(const Outline& outline, const std::string& fill) {
  std::string text;
  for (const Outline& part : parts_of(outline)) {
    const std::string data = path_data(fit_outline(part, kOutlineFit), kPxDigits);
    if (!data.empty()) text += "<path" + fill + " d=\"" + data + "\"/>\n";
  }
  return text;
}

std::string opacity_attribute(float opacity) {
  return opacity >= 1.0F ? "" : fmt::format(" opacity=\"{}\"", svg_number(opacity, 3));
}

ClassAttributes outline_attributes(const StrokeInk& ink, const Opacities& opacities) {
  ClassAttributes attributes;
  for (size_t i = 0; i < kCurveClasses; ++i) {
    const bool by_class = ink.stroke.colour == StrokeColour::by_class;
    const glm::vec3& colour = by_class ? ink.classes[i].colour : ink.ink.colour;
    const std::string fill = is_of_surface(ink.stroke.colour) ? "" : " fill=\"" + svg_colour(colour) + "\"";
    attributes.visible[i] = fill + opacity_attribute(opacities.shares[i]);
  }
  attributes.hidden = attributes.visible;
  attributes.hidden_group = opacity_attribute(ink.stroke.hidden_opacity);
  return attributes;
}

std::string note_on(const StrokeParams& stroke) {
  if (stroke.brush == Brush::solid) return "";
  return fmt::format("The paint of stroke.brush = {} cannot be held by outlines: strokes are filled evenly.",
                     ChoiceNames<Brush>::names[static_cast<size_t>(stroke.brush)]);
}

}  // namespace

std::string strokes_svg(const Strokes& strokes, const StrokeInk& ink, const VectorPage& page,
                        const std::string& below) {
  Fills fills;
  for (const Stroke& stroke : strokes.strokes) {
    if (stroke.covered == 0 || ink.stroke.hidden) add_parts(stroke, ink, fills);
  }
  const Opacities opaque = opacities(fills, ink);
  OutlineMaker maker(opaque);
  std::vector<ClassItem> items;
  for (const auto& [fill, parts] : fills) {
    stop_if_asked();
    const auto& [is_hidden, curve_class, object_id, colour] = fill;
    const std::string own = is_of_surface(ink.stroke.colour) ? " fill=\"" + colour + "\"" : "";
    items.push_back({is_hidden, curve_class, object_id, outline_elements(maker.outline(fill, parts), own)});
  }
  std::string drawn = class_groups(items, outline_attributes(ink, opaque), page.object_names);
  if (!drawn.empty())
    drawn = fmt::format("<g id=\"strokes\"{}>\n{}</g>\n", opacity_attribute(opaque.of_all), drawn);
  return svg_file(page, note_on(ink.stroke), below + drawn);
}

}  // namespace inkbench
