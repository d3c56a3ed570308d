// SPDX-License-Identifier: MIT
// The script of a chart of lines: one panel or several that share their axes, a curve for each y and by.
#include <algorithm>
#include <array>

#include "pipeline/base/text.h"
#include "studies/report/chart_colours.h"
#include "studies/report/chart_script.h"
#include "studies/report/chart_text.h"
#include "studies/report/lettering.h"

namespace inkbench {
namespace {

// Curves differ by lightness, dash and marker at once; the lists' lengths have no common factor, so that no
// pair of dash and marker comes twice.
constexpr std::array kDashes{"solid", "(14,6)", "(5,5)", "(16,5,3,5)", "(7,4)"};
constexpr std::array kMarkers{7, 5, 9, 13, 11, 15};
constexpr size_t kManyPoints = 30;  // More get markers only here and there.
constexpr size_t kShownMarkers = 12;
constexpr int kGuessedPlotPx = 450;  // Of the height, until the layout is known.

struct Extent {
  double low = 0, high = 0;
  bool is_empty = true;

  void add(double value) {
    if (std::isnan(value)) return;
    low = is_empty ? value : std::min(low, value);
    high = is_empty ? value : std::max(high, value);
    is_empty = false;
  }
};

class LinesScript {
 public:
  LinesScript(const Chart& chart, const CsvTable& table)
      : chart_(chart),
        data_(line_data(chart, table)),
        reads_file_(!chart.best_of && data_.is_sorted && is_plain(table, chart)) {
    measure();
    arrange();
  }

  std::string text() {
    write_head(script_, chart_);
    reads_file_ ? write_file_curves() : write_own_curves();
    write_canvas(script_, layout_);
    write_styles();
    write_axes();
    script_.gap();
    write_texts(script_, layout_);
    for (size_t panel = 0; panel < data_.panels.size(); ++panel) write_panel(panel);
    write_foot(script_);
    return script_.text();
  }

 private:
  void measure() {
    for (const LineCurve& curve : data_.curves) {
      for (size_t panel = 0; panel < data_.panels.size(); ++panel) {
        for (const CurvePoint& point : curve.panels[panel]) {
          if (point.x != data_.zero_at) x_.add(point.x);
          x_is_whole_ = x_is_whole_ && point.x == std::floor(point.x);
          y_.add(point.y);
        }
        most_points_ = std::max(most_points_, curve.panels[panel].size());
      }
    }
    if (x_.is_empty) x_.low = x_.high = 1;
    if (y_.is_empty) y_.low = y_.high = 1;
  }

  bool has_legend() const { return data_.curves.size() > 1; }

  ChartAxis y_axis(double length_px) const {
    ChartAxis axis = vertical_axis({y_.low,
                                    y_.high,
                                    chart_.scale_y,
                                    chart_.y_from,
                                    chart_.y_to,
                                    {},
                                    static_cast<int>(length_px),
                                    kTickSizePx});
    return y_.is_empty ? without_ticks(axis) : axis;
  }

  ChartAxis x_axis(double length_px) const {
    const int length = static_cast<int>(length_px);
    if (!data_.categories.empty()) {
      std::vector<std::string> labels;
      for (const std::string& field : data_.categories) labels.push_back(readable_field(chart_.x, field));
      return category_axis(labels, true, length, kTickSizePx);
    }
    AxisNeeds needs{x_.low, x_.high, chart_.scale_x, {}, {}, {}, length, kTickSizePx, x_is_whole_};
    if (data_.zero_at) needs.apart = ChartTick{*data_.zero_at, chart_.x.zero.empty() ? "0" : chart_.x.zero};
    ChartAxis axis = horizontal_axis(needs);
    if (!x_.is_empty) return axis;
    axis = without_ticks(axis);
    axis.break_at.reset();  // nothing stands on the near side of it
    if (needs.apart) axis.ticks.push_back(*needs.apart);
    return axis;
  }

  static ChartAxis without_ticks(ChartAxis axis) {
    axis.ticks.clear();
    axis.minor.clear();
    return axis;
  }

  /// The axes' lettering decides the panels' size and the other way round: one round of each settles it.
  void arrange() {
    LayoutNeeds needs;
    needs.title = one_line(chart_.title);
    needs.x_label = one_line(chart_.x_label);
    needs.y_label = one_line(chart_.y_label);
    set_headings(needs, chart_, data_.panels);
    if (has_legend()) add_legend(needs);
    needs.notes = notes();
    y_axis_ = y_axis(kGuessedPlotPx);
    for (int round = 0; round < 2; ++round) {
      needs.y_ticks_px = 0;
      for (const ChartTick& tick : y_axis_.ticks)
        needs.y_ticks_px = std::max(needs.y_ticks_px, text_width_px(tick.label, kTickSizePx, Face::regular));
      layout_ = lay_out(needs);
      x_axis_ = x_axis(layout_.panels.front().width());
      needs.x_ticks_px = x_axis_.labels_px;
      layout_ = lay_out(needs);
      y_axis_ = y_axis(layout_.panels.front().height());
    }
  }

  void add_legend(LayoutNeeds& needs) const {
    if (chart_.by && chart_.y.size() == 1 && !chart_.by->names_itself)
      needs.legend_heading = one_line(axis_text(*chart_.by)) + ":";
    for (const LineCurve& curve : data_.curves) {
      bool has_values = false;
      for (size_t panel = 0; panel < data_.panels.size(); ++panel)
        has_values = has_values || curve.has_values(panel);
      needs.legend.push_back(one_line(curve.label) + (has_values ? "" : " (no values)"));
    }
  }

  std::vector<std::string> notes() const {
    std::vector<std::string> notes = choice_notes(chart_);
    if (data_.off_scale > 0) {
      notes.push_back(
          fmt::format("{} not shown: a log axis has no place for 0 and below.",
                      data_.off_scale == 1 ? "1 value is" : fmt::format("{} values are", data_.off_scale)));
    }
    return notes;
  }

  static std::string block(size_t curve, size_t panel) {
    return fmt::format("$curve_{}_{}", panel + 1, curve + 1);
  }

  template <class Write>
  void for_each_curve(const Write& write) {
    for (size_t panel = 0; panel < data_.panels.size(); ++panel) {
      for (size_t i = 0; i < data_.curves.size(); ++i) {
        if (data_.curves[i].has_values(panel)) write(panel, i, data_.curves[i]);
      }
    }
  }

  std::string x_expression() const {
    if (!data_.categories.empty()) return fmt::format("place(strcol({}))", literal(chart_.x.name));
    const std::string number = fmt::format("number({})", literal(chart_.x.name));
    return data_.zero_at ? "place(" + number + ")" : number;
  }

  void write_file_curves() {
    script_.line("# The curves, each from its own rows of the table.");
    write_data_source(script_, chart_.table);
    if (!data_.categories.empty()) {
      std::vector<std::string> names;
      for (const std::string& field : data_.categories) names.push_back(literal(field));
      script_.line("array x_names[{}] = [{}]", names.size(), join(names, ", "));
      script_.line("place(text) = sum [i = 1:|x_names|] (x_names[i] eq text ? i : 0)");
    } else if (data_.zero_at) {
      script_.line("place(x) = x > 0 ? x : x == 0 ? {} : NaN  # a log axis has no place for 0",
                   shortest(*data_.zero_at));
    }
    for_each_curve([&](size_t panel, size_t i, const LineCurve& curve) {
      script_.line("set table {}", block(i, panel));
      script_.line("plot data using ({}):(number({})) with table if ({})", x_expression(),
                   literal(curve.y->name), row_condition(chart_, data_.panels[panel], curve.by));
    });
    script_.line("unset table");
    script_.line("unset datafile columnheaders");
    script_.line("set datafile separator whitespace").gap();
  }

  void write_own_curves() {
    script_.line("# The curves: x and y, NaN where there is no value. Picked from {}: {}.", chart_.table,
                 chart_.best_of ? "the best cells" : "sorted, as gnuplot cannot");
    for_each_curve([&](size_t panel, size_t i, const LineCurve& curve) {
      script_.line("{} << END", block(i, panel));
      for (const CurvePoint& point : curve.panels[panel])
        script_.line("{} {}", shortest(point.x), std::isnan(point.y) ? "NaN" : shortest(point.y));
      script_.line("END");
    });
    script_.gap();
  }

  void write_styles() {
    const std::vector<std::string> colours = curve_colours(data_.curves.size());
    const size_t interval = most_points_ > kManyPoints ? most_points_ / kShownMarkers : 1;
    for (size_t i = 0; i < data_.curves.size(); ++i) {
      script_.line("set style line {} lc rgb '{}' lw 4 dt {} pt {} ps 2*mark pi {}", i + 1, colours[i],
                   kDashes[i % kDashes.size()], kMarkers[i % kMarkers.size()], interval);
    }
  }

  void write_axes() {
    script_.line("set border 3 lc rgb '#444444' lw 1.5");
    script_.line("set grid xtics ytics lt 1 lc rgb '#dddddd' lw 1");
    script_.line("set tics scale 0.6,0.3");
    script_.line("set xtics offset 0,(kind eq 'svg' ? {} : 0)  # the SVG's stand further away",
                 x_axis_.is_turned ? 0.15 : 0.45);
    if (x_axis_.is_turned) script_.line("set xtics rotate by {} right", kTurnedDegrees);
    if (x_axis_.is_log) script_.line("set logscale x");
    if (y_axis_.is_log) script_.line("set logscale y");
    script_.line("# Ranges and ticks were fitted to the data; [*:*] fits them anew.");
    script_.line("set xrange {}", range_text(x_axis_)).line("set yrange {}", range_text(y_axis_));
  }

  void write_panel(size_t panel) {
    script_.gap();
    if (chart_.panel)
      script_.line("# {} = {}", one_line(chart_.panel->name), one_line(data_.panels[panel]) + ".");
    write_panel_place(script_, layout_, panel);
    write_ticks(script_, "x", x_axis_, layout_.is_lowest(panel));
    write_ticks(script_, "y", y_axis_, layout_.is_leftmost(panel));
    std::vector<std::string> curves;
    for (size_t i = 0; i < data_.curves.size(); ++i) {
      if (data_.curves[i].has_values(panel))
        curves.push_back(fmt::format("{} using 1:2 with linespoints ls {} notitle", block(i, panel), i + 1));
    }
    if (curves.empty()) {
      script_.line("set label 'no values' at graph 0.5,0.5 center tc rgb '#555555'");
      curves.emplace_back("NaN notitle");
    }
    if (x_axis_.break_at) {
      script_.line(
          "set arrow from first {0}, graph 0 to first {0}, graph 1 nohead dt (4,4) lc rgb '#888888' lw 1.5",
          shortest(*x_axis_.break_at));
    }
    script_.line("plot {}", join(curves, ", \\\n     "));
    script_.line("unset label; unset arrow");
  }

  const Chart& chart_;
  LineData data_;
  bool reads_file_;
  Extent x_, y_;
  bool x_is_whole_ = true;
  size_t most_points_ = 0;
  ChartLayout layout_;
  ChartAxis x_axis_, y_axis_;
  ScriptText script_;
};

}  // namespace

std::string lines_script(const Chart& chart, const CsvTable& table) {
  return LinesScript(chart, table).text();
}

}  // namespace inkbench
