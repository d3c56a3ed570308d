// SPDX-License-Identifier: MIT
// What a chart shows, picked from the table: panels, curves and their points, or the cells of heat maps. In:
// a chart and the table. Out: numbers and the order of names, without colours or places on paper.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "studies/report/chart.h"

namespace inkbench {

constexpr size_t kMaxCurves = 24;
constexpr size_t kMaxPanels = 24;
constexpr size_t kMaxHeatCells = 40'000;  ///< Of all panels.

/// The fields of one column that a chart tells apart: names in order of appearance, numbers in rising
/// order, a 0 that stands for something else last.
class FieldOrder {
 public:
  FieldOrder(const CsvTable& table, const std::vector<size_t>& rows, const ChartColumn& column);
  /// Where there is no such column, or no row: one field, which is empty.
  FieldOrder(const CsvTable& table, const std::vector<size_t>& rows,
             const std::optional<ChartColumn>& column);

  const std::vector<std::string>& fields() const { return fields_; }
  size_t size() const { return fields_.size(); }
  size_t place(const std::string& field) const { return places_.at(field); }

 private:
  std::vector<std::string> fields_;
  std::map<std::string, size_t> places_;
};

/// The rows that count: those that worked, pass the filters and are the best of theirs.
std::vector<size_t> chosen_rows(const Chart& chart, const CsvTable& table);

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

struct CurvePoint {
  double x = 0;
  double y = kNoValue;
};

using CurvePoints = std::vector<CurvePoint>;  ///< x does not fall.

struct LineCurve {
  const ChartColumn* y = nullptr;
  std::string by;                   ///< The field, empty without such a column.
  std::string label;                ///< In the legend.
  std::vector<CurvePoints> panels;  ///< One for each panel, perhaps without points.

  bool has_values(size_t panel) const;
};

struct LineData {
  std::vector<std::string> panels;  ///< Fields; one that is empty without such a column.
  std::vector<LineCurve> curves;
  std::vector<std::string> categories;  ///< Of a text column x, which stand at 1, 2, 3, ...
  std::optional<double> zero_at;        ///< Where a log axis shows x = 0, which has no place on it.
  bool is_sorted = true;                ///< In the table, x rises or falls along every curve.
  size_t off_scale = 0;                 ///< Values at or below 0 that a log axis cannot show.
};

/// Errors (input): too many curves or panels.
LineData line_data(const Chart& chart, const CsvTable& table);

struct HeatCell {
  bool exists = false;  ///< The table has a row for it.
  double value = kNoValue;
};

struct HeatData {
  std::vector<std::string> panels;           ///< Fields, as above.
  std::vector<std::string> columns, rows;    ///< Fields from left to right and from the bottom up.
  std::vector<std::vector<HeatCell>> cells;  ///< By panel, row, column.
  double low = kNoValue, high = kNoValue;    ///< Of all values; NaN where there are none.
  bool has_gaps = false;                     ///< There are cells without a value.

  const HeatCell& cell(size_t panel, size_t row, size_t column) const {
    return cells[panel][row * columns.size() + column];
  }
};

/// Errors (input): too many panels or cells.
HeatData heat_data(const Chart& chart, const CsvTable& table);

}  // namespace inkbench
