// SPDX-License-Identifier: MIT
#include "pipeline/lines/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "pipeline/lines/class_pixels.h"

namespace inkbench {
namespace {

/// Later classes first, so that earlier ones come to lie over them.
constexpr std::array<LineClass, 7> drawing_order() {
  std::array<LineClass, 7> order = kLineClasses;
  std::reverse(order.begin(), order.end());
  return order;
}

void append_path(const Polyline& line, std::string& svg) {
  const bool closed = line.points.size() > 2 && line.points.front() == line.points.back();
  auto out = std::back_inserter(svg);
  fmt::format_to(out, "<path data-object=\"{}\" d=\"", line.object_id);
  for (size_t i = 0; i + (closed ? 1 : 0) < line.points.size(); ++i)
    fmt::format_to(out, "{}{:.2f} {:.2f}", i == 0 ? "M" : "L", line.points[i].x, line.points[i].y);
  svg += closed ? "Z\"/>\n" : "\"/>\n";
}

}  // namespace

std::array<uint8_t, 3> colour_of(LineClass line_class) {
  constexpr std::array<std::array<uint8_t, 3>, 7> kColours{{{0, 0, 0},
                                                            {230, 159, 0},
                                                            {0, 114, 178},
                                                            {213, 94, 0},
                                                            {0, 158, 115},
                                                            {204, 121, 167},
                                                            {86, 180, 233}}};
  return kColours[static_cast<size_t>(line_class)];
}

Picture draw_reference(const ReferenceLines& lines) {
  return coloured_classes(class_pixels(lines));
}

Image class_image(const ReferenceLines& lines) {
  return numbered_classes(class_pixels(lines));
}

std::string reference_svg(const ReferenceLines& lines) {
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n",
      lines.width_px, lines.height_px);
  for (const LineClass line_class : drawing_order()) {
    const std::array<uint8_t, 3> colour = colour_of(line_class);
    fmt::format_to(std::back_inserter(svg),
                   "<g id=\"{}\" fill=\"none\" stroke=\"#{:02x}{:02x}{:02x}\" stroke-width=\"1\" "
                   "stroke-linejoin=\"round\">\n",
                   name_of(line_class), colour[0], colour[1], colour[2]);
    for (const Polyline& line : lines.polylines) {
      if (line.line_class == line_class) append_path(line, svg);
    }
    svg += "</g>\n";
  }
  return svg + "</svg>\n";
}

}  // namespace inkbench
