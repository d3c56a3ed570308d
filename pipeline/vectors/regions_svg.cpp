// SPDX-License-Identifier: MIT
#include "pipeline/vectors/regions_svg.h"

#include <fmt/format.h>

#include "pipeline/vectors/svg_page.h"
#include "pipeline/vectors/svg_parts.h"

namespace inkbench {

std::string regions_svg(const std::vector<TracedRegion>& regions) {
  std::string svg =
      "<g id=\"regions\" inkscape:groupmode=\"layer\" inkscape:label=\"regions\" stroke-width=\".5\" "
      "stroke-linejoin=\"round\">\n";
  for (const TracedRegion& region : regions) {
    const std::string colour =
        fmt::format("#{:02x}{:02x}{:02x}", region.colour[0], region.colour[1], region.colour[2]);
    svg += fmt::format("<path fill=\"{0}\" stroke=\"{0}\" d=\"{1}\"/>\n", colour,
                       path_data(region.outlines, kPxDigits));
  }
  return svg + "</g>\n";
}

}  // namespace inkbench
