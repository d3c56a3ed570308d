// SPDX-License-Identifier: MIT
#include "pipeline/vectors/plot_svg.h"

#include <fmt/format.h>

#include "pipeline/vectors/fit_path.h"
#include "pipeline/vectors/plot_order.h"
#include "pipeline/vectors/svg_parts.h"

namespace inkbench {
namespace {

constexpr int kMmDigits = 3;
constexpr double kOneEndPx = 0.02;    ///< Ends that near are one.
constexpr double kPlotErrorPx = 0.1;  ///< Of fitting; rounding is the rest.
constexpr double kPenMm = 0.3;        ///< How wide the file shows the pen's line.

/// Lines in mm, as they are drawn.
struct Ordered {
  std::vector<PlotLine> lines;
  double travel_before = 0.0;
};

Ordered put_in_order(const std::vector<PlotLine>& lines_px, const VectorPage& page, double mm_per_px) {
  std::vector<PlotLine> on_sheet = cut_to_sheet(lines_px, {page.width_px, page.height_px});
  std::vector<PlotLine> joined = join_ends(on_sheet, kOneEndPx);
  for (auto* lines : {&on_sheet, &joined}) {
    for (PlotLine& line : *lines) {
      for (glm::dvec2& point : line) point *= mm_per_px;
    }
  }
  return {in_short_order(std::move(joined)), lifted_travel(on_sheet)};
}

std::string plot_group(const std::string& id, const std::vector<PlotLine>& lines, double error_mm) {
  std::string paths;
  for (const PlotLine& line : lines) {
    const CubicPath path = fit_path(line, {.error = error_mm, .corner_reach = 10.0 * error_mm});
    const std::string data = path_data({&path, 1}, kMmDigits);
    if (!data.empty()) paths += "<path d=\"" + data + "\"/>\n";
  }
  if (paths.empty()) return "";
  return fmt::format(
      "<g id=\"{0}\" inkscape:groupmode=\"layer\" inkscape:label=\"{0}\" fill=\"none\" stroke=\"#000\" "
      "stroke-width=\"{1}\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n{2}</g>\n",
      id, svg_number(kPenMm, 2), paths);
}

}  // namespace

PlotDrawing plot_drawing(const Curves& curves) {
  PlotDrawing drawing;
  for (const Curve& curve : curves.curves)
    (curve.covered > 0 ? drawing.hidden : drawing.lines)
        .emplace_back(curve.points.begin(), curve.points.end());
  return drawing;
}

PlotDrawing plot_drawing(const Strokes& strokes) {
  PlotDrawing drawing;
  for (const Stroke& stroke : strokes.strokes) {
    PlotLine& line = (stroke.covered > 0 ? drawing.hidden : drawing.lines).emplace_back();
    for (const StrokePoint& point : stroke.points) line.emplace_back(point.at);
  }
  return drawing;
}

Plot plot_svg(const PlotDrawing& drawing, const PlotOptions& options, const VectorPage& page) {
  const double mm_per_px = options.width_mm / page.width_px;
  const Ordered visible = put_in_order(drawing.lines, page, mm_per_px);
  const Ordered hidden =
      put_in_order(options.draws_hidden ? drawing.hidden : std::vector<PlotLine>{}, page, mm_per_px);
  Plot plot;
  plot.lines = visible.lines.size() + hidden.lines.size();
  plot.travel = {visible.travel_before + hidden.travel_before,
                 lifted_travel(visible.lines) + lifted_travel(hidden.lines)};
  const std::string note =
      fmt::format("{} lines; the pen travels {} mm lifted, {} mm in the order in which the lines were found.",
                  plot.lines, svg_number(plot.travel.after, 0), svg_number(plot.travel.before, 0));
  const double error_mm = kPlotErrorPx * mm_per_px;
  plot.svg =
      svg_file_mm(page, options.width_mm, page.height_px * mm_per_px, note,
                  plot_group("plot", visible.lines, error_mm) + plot_group("hidden", hidden.lines, error_mm));
  return plot;
}

}  // namespace inkbench
