// SPDX-License-Identifier: MIT
#include "studies/report/chart_data.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"
#include "studies/report/chart_text.h"

namespace inkbench {
namespace {

using Row = std::vector<std::string>;

bool passes(const CsvTable& table, const Row& row, const Chart& chart) {
  const auto error = std::find(table.columns.begin(), table.columns.end(), "error");
  if (error != table.columns.end() && !row[static_cast<size_t>(error - table.columns.begin())].empty())
    return false;
  return std::all_of(chart.where.begin(), chart.where.end(), [&](const ChartFilter& filter) {
    const std::string& field = row[table.column(filter.column.name)];
    return std::find(filter.fields.begin(), filter.fields.end(), field) != filter.fields.end();
  });
}

/// The columns whose fields together make one point of the chart (of each y).
std::vector<const ChartColumn*> point_columns(const Chart& chart) {
  std::vector<const ChartColumn*> columns{&chart.x};
  if (chart.kind == ChartKind::heatmap) columns.push_back(&chart.y.front());
  if (chart.by) columns.push_back(&*chart.by);
  if (chart.panel) columns.push_back(&*chart.panel);
  return columns;
}

Row point_fields(const CsvTable& table, const Row& row, const std::vector<const ChartColumn*>& columns) {
  Row fields;
  for (const ChartColumn* column : columns) fields.push_back(row[table.column(column->name)]);
  return fields;
}

std::vector<size_t> best_rows(const Chart& chart, const CsvTable& table, const std::vector<size_t>& rows) {
  const size_t column = table.column(chart.best_of->name);
  const std::vector<const ChartColumn*> columns = point_columns(chart);
  std::map<Row, std::pair<size_t, double>> best;
  for (const size_t row : rows) {
    const std::optional<double> number = number_in(table.rows[row][column]);
    if (!number) continue;
    const double rank = chart.best_of_least ? -*number : *number;
    const auto [entry, is_new] = best.try_emplace(point_fields(table, table.rows[row], columns), row, rank);
    if (!is_new && rank > entry->second.second) entry->second = {row, rank};
  }
  std::vector<size_t> result;
  for (const auto& [fields, entry] : best) result.push_back(entry.first);
  std::sort(result.begin(), result.end());
  return result;
}

[[noreturn]] void refuse(const std::string& what, size_t count, size_t limit) {
  throw input_error(
      "", fmt::format("{} {}", with_commas(static_cast<long long>(count)), what),
      fmt::format("at most {}; choose some with where", with_commas(static_cast<long long>(limit))));
}

/// Turns x fields into places on the axis, and remembers what a log axis cannot show.
class XPlaces {
 public:
  XPlaces(const Chart& chart, const CsvTable& table, const std::vector<size_t>& rows)
      : chart_(chart), order_(table, rows, chart.x) {
    if (chart.x.is_text || chart.scale_x == Scale::linear) return;
    double least = std::numeric_limits<double>::infinity();
    double greatest = 0;
    bool has_zero = false;
    for (const std::string& field : order_.fields()) {
      const double x = number_in(field).value_or(-1);
      has_zero = has_zero || x == 0;
      if (x <= 0) continue;
      least = std::min(least, x);
      greatest = std::max(greatest, x);
    }
    if (!has_zero) return;
    if (greatest == 0) least = greatest = 1;
    const double step = std::max(1.5, std::pow(greatest / least, 0.15));
    zero_at_ = chart.x.zero.empty() ? least / step : greatest * step;
  }

  std::optional<double> place(const std::string& field) const {
    if (chart_.x.is_text) return static_cast<double>(order_.place(field)) + 1;
    const std::optional<double> x = number_in(field);
    if (!x || chart_.scale_x == Scale::linear || *x > 0) return x;
    return *x == 0 ? zero_at_ : std::nullopt;
  }

  const std::vector<std::string>& fields() const { return order_.fields(); }
  std::optional<double> zero_at() const { return zero_at_; }

 private:
  const Chart& chart_;
  FieldOrder order_;
  std::optional<double> zero_at_;
};

std::string curve_label(const Chart& chart, const ChartColumn& y, const std::string& by) {
  // Where the axis names no unit, each curve names its own.
  const std::string label = chart.y.size() > 1 && chart.y_label.empty() ? axis_text(y) : y.label;
  if (!chart.by || by.empty()) return label;
  const std::string value = readable_field(*chart.by, by);
  return chart.y.size() == 1 ? value : label + ", " + value;
}

std::vector<LineCurve> empty_curves(const Chart& chart, const FieldOrder& bys, size_t panels) {
  std::vector<LineCurve> curves;
  for (const ChartColumn& y : chart.y) {
    for (const std::string& by : bys.fields())
      curves.push_back({&y, by, curve_label(chart, y, by), std::vector<CurvePoints>(panels)});
  }
  return curves;
}

/// Sorts a curve by x; returns whether it already rose or fell.
bool sort_points(CurvePoints& points) {
  const auto before = [](const CurvePoint& a, const CurvePoint& b) { return a.x < b.x; };
  const bool rises = std::is_sorted(points.begin(), points.end(), before);
  const bool falls = std::is_sorted(points.rbegin(), points.rend(), before);
  if (!rises) std::stable_sort(points.begin(), points.end(), before);
  return rises || falls;
}

}  // namespace

FieldOrder::FieldOrder(const CsvTable& table, const std::vector<size_t>& rows, const ChartColumn& column) {
  const size_t index = table.column(column.name);
  for (const size_t row : rows) {
    const std::string& field = table.rows[row][index];
    if (places_.try_emplace(field, 0).second) fields_.push_back(field);
  }
  if (!column.is_text) {
    const auto rank = [&](const std::string& field) {
      constexpr double kLast = std::numeric_limits<double>::infinity();
      const double number = number_in(field).value_or(kLast);
      return number == 0 && !column.zero.empty() ? kLast : number;
    };
    std::stable_sort(fields_.begin(), fields_.end(),
                     [&](const std::string& a, const std::string& b) { return rank(a) < rank(b); });
  }
  for (size_t i = 0; i < fields_.size(); ++i) places_[fields_[i]] = i;
}

FieldOrder::FieldOrder(const CsvTable& table, const std::vector<size_t>& rows,
                       const std::optional<ChartColumn>& column) {
  if (column) *this = FieldOrder(table, rows, *column);
  if (!fields_.empty()) return;
  fields_.emplace_back();
  places_[""] = 0;
}

bool LineCurve::has_values(size_t panel) const {
  return std::any_of(panels[panel].begin(), panels[panel].end(),
                     [](const CurvePoint& point) { return !std::isnan(point.y); });
}

std::vector<size_t> chosen_rows(const Chart& chart, const CsvTable& table) {
  std::vector<size_t> rows;
  for (size_t i = 0; i < table.rows.size(); ++i) {
    if (passes(table, table.rows[i], chart)) rows.push_back(i);
  }
  return chart.best_of ? best_rows(chart, table, rows) : rows;
}

LineData line_data(const Chart& chart, const CsvTable& table) {
  const std::vector<size_t> rows = chosen_rows(chart, table);
  const FieldOrder panels(table, rows, chart.panel);
  const FieldOrder bys(table, rows, chart.by);
  const size_t curves = bys.size() * chart.y.size();
  if (panels.size() > kMaxPanels) refuse("panels", panels.size(), kMaxPanels);
  if (curves > kMaxCurves) refuse("curves", curves, kMaxCurves);
  const XPlaces places(chart, table, rows);

  LineData data;
  data.panels = panels.fields();
  data.curves = empty_curves(chart, bys, panels.size());
  data.zero_at = places.zero_at();
  if (chart.x.is_text) data.categories = places.fields();
  for (const size_t index : rows) {
    const Row& row = table.rows[index];
    const std::string& x_field = row[table.column(chart.x.name)];
    const std::optional<double> x = places.place(x_field);
    const bool x_is_off = !x && number_in(x_field).has_value();
    const size_t panel = chart.panel ? panels.place(row[table.column(chart.panel->name)]) : 0;
    const size_t by = chart.by ? bys.place(row[table.column(chart.by->name)]) : 0;
    for (size_t i = 0; i < chart.y.size(); ++i) {
      std::optional<double> y = number_in(row[table.column(chart.y[i].name)]);
      const bool is_off = y && (x_is_off || (chart.scale_y == Scale::log && *y <= 0));
      data.off_scale += is_off ? 1 : 0;
      if (is_off) y.reset();
      if (x) data.curves[i * bys.size() + by].panels[panel].push_back({*x, y.value_or(kNoValue)});
    }
  }
  for (LineCurve& curve : data.curves) {
    for (CurvePoints& points : curve.panels) data.is_sorted = sort_points(points) && data.is_sorted;
  }
  return data;
}

HeatData heat_data(const Chart& chart, const CsvTable& table) {
  const std::vector<size_t> chosen = chosen_rows(chart, table);
  const FieldOrder panels(table, chosen, chart.panel);
  const FieldOrder columns(table, chosen, chart.x);
  const FieldOrder rows(table, chosen, chart.y.front());
  const size_t cells = panels.size() * columns.size() * rows.size();
  if (panels.size() > kMaxPanels) refuse("panels", panels.size(), kMaxPanels);
  if (cells > kMaxHeatCells) refuse("cells in a heat map", cells, kMaxHeatCells);

  HeatData data{panels.fields(), columns.fields(), rows.fields()};
  // Names read from the top down, amounts from the bottom up.
  if (chart.y.front().is_text) std::reverse(data.rows.begin(), data.rows.end());
  data.cells.assign(panels.size(), std::vector<HeatCell>(columns.size() * rows.size()));
  for (const size_t index : chosen) {
    const Row& row = table.rows[index];
    const size_t panel = chart.panel ? panels.place(row[table.column(chart.panel->name)]) : 0;
    const size_t from_start = rows.place(row[table.column(chart.y.front().name)]);
    const size_t y = chart.y.front().is_text ? rows.size() - 1 - from_start : from_start;
    HeatCell& cell = data.cells[panel][y * columns.size() + columns.place(row[table.column(chart.x.name)])];
    cell = {true, number_in(row[table.column(chart.value->name)]).value_or(kNoValue)};
    data.low = std::fmin(data.low, cell.value);
    data.high = std::fmax(data.high, cell.value);
    data.has_gaps = data.has_gaps || std::isnan(cell.value);
  }
  return data;
}

}  // namespace inkbench
