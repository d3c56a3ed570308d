// SPDX-License-Identifier: MIT
#include "studies/report/curve_chart.h"

#include <array>
#include <cassert>

#include "pipeline/base/text.h"
#include "studies/report/chart_colours.h"
#include "studies/report/chart_script.h"
#include "studies/report/chart_text.h"
#include "studies/report/lettering.h"

namespace inkbench {
namespace {

constexpr std::array kStrengthDashes{"solid", "(14,6)", "(5,5)", "(16,5,3,5)", "(7,4)"};
constexpr int kFirstIso = 1, kLastIso = 9;  // tenths of F
constexpr int kIsoLabelPx = 60;             // Right of the plot.
constexpr int kLegendGapPx = 14;
constexpr int kDetailSizePx = 20;
constexpr size_t kMostDetailed = 9;  // More curves stand on one line each.
constexpr const char* kIsoColour = "#7fb08a";

class StrengthScript {
 public:
  explicit StrengthScript(const StrengthChart& chart) : chart_(chart) {
    assert(!chart.curves.empty() && chart.curves.size() <= kMostStrengthCurves);
    arrange();
    place_legend();
  }

  std::string text() {
    write_head(script_, {chart_.name, chart_.title, chart_.of, chart_.writer});
    write_curves();
    write_canvas(script_, layout_);
    write_styles();
    write_axes();
    script_.gap();
    write_texts(script_, layout_);
    write_plot();
    write_foot(script_);
    return script_.text();
  }

 private:
  static ChartAxis share_axis() {
    ChartAxis axis;
    for (int tenth = 0; tenth <= 10; tenth += 2)
      axis.ticks.push_back({tenth / 10.0, readable_number(tenth / 10.0, 1)});
    for (int tenth = 1; tenth < 10; tenth += 2) axis.minor.push_back(tenth / 10.0);
    return axis;
  }

  /// A square plot on the left: how wide it may be is known once its height is.
  void arrange() {
    LayoutNeeds needs;
    needs.title = one_line(chart_.title);
    needs.x_label = "recall";
    needs.y_label = "precision";
    needs.headings = {""};
    needs.notes = chart_.notes;
    needs.y_ticks_px = text_width_px("0.0", kTickSizePx, Face::regular);
    needs.x_ticks_px = line_height_px(kTickSizePx);
    layout_ = lay_out(needs);
    const ChartBox& wide = layout_.panels.front();
    needs.right_px = static_cast<int>(wide.width() - wide.height());
    layout_ = lay_out(needs);
  }

  void place_legend() {
    const ChartBox& box = layout_.panels.front();
    const bool is_detailed = chart_.curves.size() <= kMostDetailed;
    const double left = box.right + kIsoLabelPx + kLegendGapPx, text_left = left + kLegendMarkPx + 14;
    const int room = static_cast<int>(kChartWidthPx - 10 - text_left);
    double y = box.top + 12;
    for (const StrengthCurveLine& curve : chart_.curves) {
      const std::string label = one_line(is_detailed ? curve.label : curve.label + ": " + curve.detail);
      layout_.legend_marks.push_back({left, y});
      layout_.texts.push_back({shortened(label, room, kTickSizePx), text_left, y, kTickSizePx});
      y += line_height_px(kTickSizePx);
      if (!is_detailed) continue;
      layout_.texts.push_back({shortened(one_line(curve.detail), room, kDetailSizePx), text_left, y,
                               kDetailSizePx, TextAlign::left, false, "#555555"});
      y += line_height_px(kDetailSizePx) + 8;
    }
  }

  void write_curves() {
    script_.line("# The curves: recall and precision by threshold, and each one's best F.");
    for (size_t i = 0; i < chart_.curves.size(); ++i) {
      script_.line("$curve_{} << END", i + 1);
      for (const CurvePoint& point : chart_.curves[i].points)
        script_.line("{} {}", shortest(point.x), shortest(point.y));
      script_.line("END");
    }
    script_.line("$best << END");
    for (const StrengthCurveLine& curve : chart_.curves)
      script_.line("{} {}", shortest(curve.best.x), shortest(curve.best.y));
    script_.line("END").gap();
  }

  void write_styles() {
    const std::vector<std::string> colours = curve_colours(chart_.curves.size());
    for (size_t i = 0; i < colours.size(); ++i) {
      script_.line("set style line {} lc rgb '{}' lw 4 dt {} pt 7 ps 2*mark", i + 1, colours[i],
                   kStrengthDashes[i % kStrengthDashes.size()]);
    }
  }

  void write_axes() {
    script_.line("set border 3 lc rgb '#444444' lw 1.5");
    script_.line("set tics scale 0.6,0.3");
    script_.line("set xtics offset 0,(kind eq 'svg' ? 0.45 : 0)  # the SVG's stand further away");
    script_.line("set xrange [0:1]").line("set yrange [0:1]").line("set samples 201");
    script_.line("# Lines of equal F: the precision that makes it F at that recall.");
    script_.line("iso(F, x) = F*x/(2*x - F)");
  }

  void write_plot() {
    script_.gap();
    write_panel_place(script_, layout_, 0);
    write_ticks(script_, "x", share_axis(), true);
    write_ticks(script_, "y", share_axis(), true);
    std::vector<std::string> plots;
    for (int tenth = kFirstIso; tenth <= kLastIso; ++tenth) {
      const double f = tenth / 10.0;
      script_.line("set label {} at first 1,{:.4f} left offset 0.4,0 font ',{}' tc rgb '#3f7f50'",
                   literal((tenth == kLastIso ? "F " : "") + readable_number(f, 1)), f / (2 - f),
                   kNoteSizePx);
      plots.push_back(fmt::format(
          "[x={:.6f}:1] '+' using (x):(iso({}, x)) with lines lc rgb '{}' lw 1.2 dt solid notitle",
          f / (2 - f), readable_number(f, 1), kIsoColour));
    }
    for (size_t i = 0; i < chart_.curves.size(); ++i) {
      plots.push_back(fmt::format("$curve_{0} using 1:2 with lines ls {0} notitle", i + 1));
      plots.push_back(fmt::format("$best every ::{}::{} using 1:2 with points ls {} notitle", i, i, i + 1));
    }
    script_.line("plot sample {}", join(plots, ", \\\n     "));
    script_.line("unset label; unset arrow");
  }

  const StrengthChart& chart_;
  ChartLayout layout_;
  ScriptText script_;
};

}  // namespace

std::string strength_chart_script(const StrengthChart& chart) {
  return StrengthScript(chart).text();
}

}  // namespace inkbench
