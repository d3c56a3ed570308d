// SPDX-License-Identifier: MIT
#include "pipeline/vectors/strokes_svg.h"

#include <fmt/format.h>

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

/// What is drawn as one: hidden, class, object.
using Group = std::tuple<bool, CurveClass, int>;
using Groups = std::map<Group, std::vector<StrokePart>>;

/// A stroke in parts of one class each.
void add_parts(const Stroke& stroke, Groups& groups) {
  const auto& points = stroke.points;
  for (size_t first = 0; first + 1 < points.size();) {
    size_t last = first + 1;
    while (last + 1 < points.size() && points[last].curve_class == points[first].curve_class) ++last;
    groups[{stroke.covered > 0, points[first].curve_class, stroke.object_id}].push_back(
        {&stroke, first, last});
    first = last;
  }
}

std::string outline_elements(const std::vector<StrokePart>& parts) {
  std::string text;
  for (const Outline& part : parts_of(stroke_outline(parts))) {
    const std::string data = path_data(fit_outline(part, kOutlineFit), kPxDigits);
    if (!data.empty()) text += "<path d=\"" + data + "\"/>\n";
  }
  return text;
}

std::string opacity_attribute(float opacity) {
  return opacity >= 1.0F ? "" : fmt::format(" opacity=\"{}\"", svg_number(opacity, 3));
}

ClassAttributes outline_attributes(const StrokeInk& ink) {
  ClassAttributes attributes;
  for (size_t i = 0; i < kCurveClasses; ++i) {
    const StrokeClassParams& look = ink.classes[i];
    const glm::vec3 colour = ink.stroke.colour == StrokeColour::by_class ? look.colour : ink.ink.colour;
    attributes.visible[i] = " fill=\"" + svg_colour(colour) + "\"" + opacity_attribute(look.opacity);
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
  Groups groups;
  for (const Stroke& stroke : strokes.strokes) {
    if (stroke.covered == 0 || ink.stroke.hidden) add_parts(stroke, groups);
  }
  std::vector<ClassItem> items;
  for (const auto& [group, parts] : groups) {
    stop_if_asked();
    const auto& [is_hidden, curve_class, object_id] = group;
    items.push_back({is_hidden, curve_class, object_id, outline_elements(parts)});
  }
  std::string drawn = class_groups(items, outline_attributes(ink), page.object_names);
  if (!drawn.empty())
    drawn = fmt::format("<g id=\"strokes\"{}>\n{}</g>\n", opacity_attribute(ink.stroke.opacity), drawn);
  return svg_file(page, note_on(ink.stroke), below + drawn);
}

}  // namespace inkbench
