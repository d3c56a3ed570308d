// SPDX-License-Identifier: MIT
// The script of a heat map: cells of one size for each pair of x and y, coloured by a value, its best one
// outlined.
#include <algorithm>
#include <cmath>

#include "pipeline/base/text.h"
#include "studies/report/chart_colours.h"
#include "studies/report/chart_script.h"
#include "studies/report/chart_text.h"
#include "studies/report/lettering.h"

namespace inkbench {
namespace {

constexpr int kScaleGapPx = 30;  // From the panels to the colour scale.
constexpr int kScaleWidthPx = 28;
constexpr int kScaleTextGapPx = 30;  // From the scale to its numbers and its name.
constexpr int kLargestValuePx = 26;  // Lettering in the cells.
constexpr int kSmallestValuePx = 15;
constexpr double kSeamPx = 1;       // Of paper, on each side of a cell that is not tiny.
constexpr double kOverlapPx = 0.4;  // Of tiny cells, or their blurred borders would shine through.
constexpr double kTinyCellPx = 10;
constexpr double kOutlinePx = 4;
constexpr double kDarkFrom = 0.55;  // From this part of the scale on, lettering is white.
constexpr int kToldApart = 50;      // Steps of the values' range that their decimals tell apart.

class HeatScript {
 public:
  HeatScript(const Chart& chart, const CsvTable& table)
      : chart_(chart), data_(heat_data(chart, table)), reads_file_(!chart.best_of && is_plain(table, chart)) {
    for (const std::string& field : data_.columns) columns_.push_back(readable_field(chart.x, field));
    for (const std::string& field : data_.rows) rows_.push_back(readable_field(chart.y.front(), field));
    arrange();
    choose_lettering();
  }

  std::string text() {
    write_head(script_, chart_);
    if (!is_empty()) reads_file_ ? write_file_cells() : write_own_cells();
    if (has_best()) write_best();
    script_.gap();
    write_canvas(script_, layout_);
    write_colours();
    script_.gap();
    write_texts(script_, layout_);
    for (size_t panel = 0; panel < data_.panels.size(); ++panel) write_panel(panel);
    write_foot(script_);
    return script_.text();
  }

 private:
  bool is_empty() const { return std::isnan(data_.low); }

  /// A best cell is one that was measured to be so, and is not like all others.
  bool has_best() const { return chart_.value->is_measured && data_.low < data_.high; }

  bool has_values(size_t panel) const {
    return std::any_of(data_.cells[panel].begin(), data_.cells[panel].end(),
                       [](const HeatCell& cell) { return !std::isnan(cell.value); });
  }

  ChartAxis scale(double length_px) const {
    if (is_empty()) return {};
    return scale_axis(
        {data_.low, data_.high, Scale::linear, {}, {}, {}, static_cast<int>(length_px), kTickSizePx});
  }

  static int widest(const ChartAxis& axis) {
    int widest = 0;
    for (const ChartTick& tick : axis.ticks)
      widest = std::max(widest, text_width_px(tick.label, kTickSizePx, Face::regular));
    return widest;
  }

  void arrange() {
    LayoutNeeds needs;
    needs.title = one_line(chart_.title);
    needs.x_label = one_line(chart_.x_label);
    needs.y_label = one_line(chart_.y_label);
    set_headings(needs, chart_, data_.panels);
    needs.notes = notes();
    double height = kChartHeightPx / 2.0;
    double whole_height = height;
    for (int round = 0; round < 2; ++round) {
      scale_ = scale(whole_height);
      y_axis_ =
          rows_.empty() ? ChartAxis{} : upright_category_axis(rows_, static_cast<int>(height), kTickSizePx);
      needs.y_ticks_px = widest(y_axis_);
      needs.right_px =
          kScaleGapPx + kScaleWidthPx + kScaleTextGapPx + widest(scale_) + line_height_px(kLabelSizePx);
      layout_ = lay_out(needs);
      const int width = static_cast<int>(layout_.panels.front().width());
      x_axis_ =
          columns_.empty() ? ChartAxis{} : category_axis(columns_, chart_.x.is_text, width, kTickSizePx);
      needs.x_ticks_px = x_axis_.labels_px;
      layout_ = lay_out(needs);
      height = layout_.panels.front().height();
      whole_height = layout_.panels.back().bottom - layout_.panels.front().top;
    }
    place_scale();
  }

  std::vector<std::string> notes() const {
    std::vector<std::string> notes = choice_notes(chart_);
    if (is_empty()) return notes;
    std::string note;
    if (has_best())
      note = fmt::format("Outlined: the {} {}{}.", chart_.mark_least ? "least" : "greatest",
                         chart_.value->label, data_.panels.size() > 1 ? " of each panel" : "");
    if (has_best() && chart_.mark_within)
      note += fmt::format(" Orange: within {} of it.", shortest(*chart_.mark_within));
    if (data_.has_gaps) note += note.empty() ? "\u00d7: no value." : "  \u00d7: no value.";
    if (!note.empty()) notes.push_back(note);
    return notes;
  }

  void place_scale() {
    double right = 0;
    scale_box_ = layout_.panels.front();
    for (const ChartBox& box : layout_.panels) {
      right = std::max(right, box.right);
      scale_box_.bottom = std::max(scale_box_.bottom, box.bottom);
    }
    scale_box_.left = right + kScaleGapPx;
    scale_box_.right = scale_box_.left + kScaleWidthPx;
    const double x = scale_box_.right + kScaleTextGapPx + widest(scale_) + line_height_px(kLabelSizePx) / 2.0;
    const int room = static_cast<int>(scale_box_.height());
    layout_.texts.push_back({shortened(one_line(chart_.value_label), room, kLabelSizePx), x,
                             (scale_box_.top + scale_box_.bottom) / 2, kLabelSizePx, TextAlign::center,
                             true});
  }

  double cell_width() const { return layout_.panels.front().width() / static_cast<double>(columns_.size()); }
  double cell_height() const { return layout_.panels.front().height() / static_cast<double>(rows_.size()); }

  /// The decimals and the size with which all values fit into their cells; size 0 where none fits.
  void choose_lettering() {
    if (is_empty()) return;
    bool all_whole = true;
    for (const std::vector<HeatCell>& panel : data_.cells) {
      for (const HeatCell& cell : panel)
        all_whole = all_whole && (std::isnan(cell.value) || cell.value == std::floor(cell.value));
    }
    decimals_ = all_whole ? 0 : decimals_for(data_.low, data_.high, kToldApart);
    int widest_px = 0;
    for (const double v : {data_.low, data_.high})
      widest_px = std::max(widest_px, text_width_px(readable_number(v, decimals_), 100, Face::regular));
    const double by_width = cell_width() * 0.82 * 100 / widest_px;
    const int size =
        static_cast<int>(std::min({by_width, cell_height() * 0.62, static_cast<double>(kLargestValuePx)}));
    value_size_px_ = size >= kSmallestValuePx ? size : 0;
  }

  static std::string names(const std::vector<std::string>& fields) {
    std::vector<std::string> texts;
    for (const std::string& field : fields) texts.push_back(literal(field));
    return fmt::format("[{}] = [{}]", fields.size(), join(texts, ", "));
  }

  void write_file_cells() {
    script_.line("# The cells: column, row and value, for each panel from its own rows of the table.");
    write_data_source(script_, chart_.table);
    script_.line("array x_names{}", names(data_.columns)).line("array y_names{}", names(data_.rows));
    script_.line("x_place(text) = sum [i = 1:|x_names|] (x_names[i] eq text ? i : 0)");
    script_.line("y_place(text) = sum [i = 1:|y_names|] (y_names[i] eq text ? i : 0)");
    for (size_t panel = 0; panel < data_.panels.size(); ++panel) {
      script_.line("set table $cells_{}", panel + 1);
      script_.line(
          "plot data using (x_place(strcol({}))):(y_place(strcol({}))):(number({})) with table if ({})",
          literal(chart_.x.name), literal(chart_.y.front().name), literal(chart_.value->name),
          row_condition(chart_, data_.panels[panel], ""));
    }
    script_.line("unset table");
    script_.line("unset datafile columnheaders");
    script_.line("set datafile separator whitespace");
  }

  void write_own_cells() {
    script_.line("# The cells: column, row and value, NaN where there is none. Picked from {}{}.",
                 chart_.table, chart_.best_of ? ": the best cells" : "");
    for (size_t panel = 0; panel < data_.panels.size(); ++panel) {
      script_.line("$cells_{} << END", panel + 1);
      for (size_t row = 0; row < rows_.size(); ++row) {
        for (size_t column = 0; column < columns_.size(); ++column) {
          const HeatCell& cell = data_.cell(panel, row, column);
          if (!cell.exists) continue;
          script_.line("{} {} {}", column + 1, row + 1,
                       std::isnan(cell.value) ? "NaN" : shortest(cell.value));
        }
      }
      script_.line("END");
    }
  }

  void write_best() {
    for (size_t panel = 0; panel < data_.panels.size(); ++panel) {
      if (has_values(panel)) script_.line("stats $cells_{0} using 3 name 'cells_{0}' nooutput", panel + 1);
    }
  }

  void write_colours() {
    std::vector<std::string> stops;
    const std::vector<std::string> colours = heat_colours();
    for (size_t i = 0; i < colours.size(); ++i) stops.push_back(fmt::format("{} '{}'", i, colours[i]));
    script_.line("unset border");
    script_.line("set tics scale 0");
    if (x_axis_.is_turned) script_.line("set xtics rotate by {} right", kTurnedDegrees);
    script_.line("set xrange {}", range_text(x_axis_)).line("set yrange {}", range_text(y_axis_));
    if (is_empty()) return;
    script_.line("# Lightness falls evenly, so that the scale also holds in grey.");
    script_.line("set palette defined ({})", join(stops, ", "));
    script_.line("# Range and ticks of the scale were fitted to the data.");
    script_.line("set cbrange {}", range_text(scale_));
    write_ticks(script_, "cb", scale_, true);
    script_.line("set colorbox user origin screen {:.4f},{:.4f} size screen {:.4f},{:.4f} noborder",
                 scale_box_.left / kChartWidthPx, 1 - scale_box_.bottom / layout_.height_px,
                 scale_box_.width() / kChartWidthPx, scale_box_.height() / layout_.height_px);
    write_value_text();
  }

  void write_value_text() {
    if (value_size_px_ == 0) return;
    script_.line("ink(v) = (v - {}) > {} * {} ? 0xffffff : 0x111111", shortest(scale_.low), kDarkFrom,
                 shortest(scale_.high - scale_.low));
    if (std::max(std::abs(data_.low), std::abs(data_.high)) < 999.5) {
      script_.line("value_text(v) = sprintf('%.{}f', v)", decimals_);
      return;
    }
    script_.line(
        "grouped(v) = v < 1000 ? sprintf('%.0f', v) : grouped(floor(v / 1000)).sprintf(',%03.0f', v - 1000 * "
        "floor(v / 1000))");
    script_.line("value_text(v) = (v < 0 ? '-' : '').grouped(floor(abs(v) + 0.5))");
  }

  std::string box(double inset_px) const {
    return fmt::format("({:.4f}):({:.4f})", 0.5 - inset_px / cell_width(), 0.5 - inset_px / cell_height());
  }

  std::vector<std::string> layers(size_t panel) const {
    const std::string cells = fmt::format("$cells_{}", panel + 1);
    const bool is_tiny = std::min(cell_width(), cell_height()) < kTinyCellPx;
    std::vector<std::string> layers;
    layers.push_back(fmt::format(
        "{} using (valid(3) ? $1 : NaN):2:{}:3 with boxxyerror fc palette fs solid noborder notitle", cells,
        box(is_tiny ? -kOverlapPx : kSeamPx)));
    if (data_.has_gaps && !is_tiny)
      layers.push_back(
          cells +
          " using (valid(3) ? NaN : $1):2 with points pt 2 ps 2.4*mark lw 2 lc rgb '#999999' notitle");
    if (value_size_px_ > 0) {
      layers.push_back(fmt::format(
          "{} using (valid(3) ? $1 : NaN):2:(value_text($3)):(ink($3)) with labels font ',{}' tc rgb "
          "variable notitle",
          cells, value_size_px_));
    }
    if (!has_best()) return layers;
    if (chart_.mark_within) layers.push_back(plateau(cells, panel, is_tiny));
    const std::string best = fmt::format("{} using ($3 == cells_{}_{} ? $1 : NaN):2:", cells, panel + 1,
                                         chart_.mark_least ? "min" : "max");
    for (const auto& [colour, inset_px] :
         {std::pair{"#ffffff", is_tiny ? -1.0 : 1.5}, std::pair{"#000000", is_tiny ? -4.0 : -1.5}}) {
      layers.push_back(fmt::format("{}{} with boxxyerror lc rgb '{}' lw {} fs empty border notitle", best,
                                   box(inset_px), colour, kOutlinePx));
    }
    return layers;
  }

  std::string plateau(const std::string& cells, size_t panel, bool is_tiny) const {
    const std::string beyond = chart_.mark_least
                                   ? fmt::format("$3 <= cells_{}_min + {}", panel + 1, *chart_.mark_within)
                                   : fmt::format("$3 >= cells_{}_max - {}", panel + 1, *chart_.mark_within);
    return fmt::format(
        "{} using ({} ? $1 : NaN):2:{} with boxxyerror lc rgb '#ff8c1a' lw {} fs empty border notitle", cells,
        beyond, box(is_tiny ? 0.0 : 1.5), kOutlinePx);
  }

  void write_panel(size_t panel) {
    script_.gap();
    if (chart_.panel) script_.line("# {} = {}.", one_line(chart_.panel->name), one_line(data_.panels[panel]));
    write_panel_place(script_, layout_, panel);
    write_ticks(script_, "x", x_axis_, layout_.is_lowest(panel));
    write_ticks(script_, "y", y_axis_, layout_.is_leftmost(panel));
    std::vector<std::string> plots{"NaN notitle"};
    if (has_values(panel)) {
      plots = layers(panel);
    } else {
      script_.line("set label 'no values' at graph 0.5,0.5 center tc rgb '#555555'");
    }
    script_.line("plot {}", join(plots, ", \\\n     "));
    script_.line("unset label{}", has_values(panel) ? "; unset colorbox" : "");
  }

  const Chart& chart_;
  HeatData data_;
  bool reads_file_;
  std::vector<std::string> columns_, rows_;  ///< Labels.
  ChartLayout layout_;
  ChartAxis x_axis_, y_axis_, scale_;
  ChartBox scale_box_;
  int decimals_ = 0;
  int value_size_px_ = 0;
  ScriptText script_;
};

}  // namespace

std::string heatmap_script(const Chart& chart, const CsvTable& table) {
  return HeatScript(chart, table).text();
}

}  // namespace inkbench
