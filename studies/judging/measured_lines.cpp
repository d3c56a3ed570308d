#include "studies/judging/measured_lines.h"

#include <algorithm>
#include <iterator>

namespace inkbench {
namespace {

std::vector<Polyline> lines_to_follow(const ReferenceLines& lines) {
  std::vector<Polyline> result;
  std::copy_if(lines.polylines.begin(), lines.polylines.end(), std::back_inserter(result),
               [](const Polyline& line) {
                 return tier(line.line_class) == 1 && line.line_class != LineClass::object;
               });
  return result;
}

}  // namespace

LineMap drawn_lines(const Image& combined_edges) {
  LineMap map(combined_edges.width_px, combined_edges.height_px);
  for (int y = 0; y < map.height_px(); ++y) {
    for (int x = 0; x < map.width_px(); ++x) {
      if (combined_edges.at(x, y) > 0.0F) map.set(x, y);
    }
  }
  return map;
}

LineView line_view(const LineMap& drawn, const ReferenceLines& lines) {
  LineMap outline = class_map(lines, LineClass::silhouette);
  for (const LineClass line_class : {LineClass::boundary, LineClass::object}) {
    outline = united(outline, class_map(lines, line_class));
  }
  return {drawn, tier_map(lines, 1), tier_map(lines, 2), outline};
}

LineTally tally_view(const LineView& view, const ReferenceLines& lines, double tolerance_px) {
  const std::vector<Polyline> followed = lines_to_follow(lines);
  return tally_lines({.prediction = view.drawn,
                      .reference = view.wanted,
                      .allowed = &view.allowed,
                      .polylines = followed,
                      .tolerance_px = tolerance_px});
}

}  // namespace inkbench
