// SPDX-License-Identifier: MIT
// A chart of a study: which columns of data.csv it shows, and how. In: such a description and the table. Out:
// the text of a gnuplot script that draws the chart. Knows no spec and starts no process.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/params/description.h"
#include "studies/report/csv.h"

namespace inkbench {

enum class ChartKind { lines, heatmap };

/// A column of data.csv and how to read it.
struct ChartColumn {
  std::string name;           ///< In the table's head.
  std::string label;          ///< For people, without the unit.
  std::string unit;           ///< Empty where there is none.
  std::string zero;           ///< What 0 stands for where it is no amount: "as loaded"; else empty.
  bool is_text = false;       ///< Its fields are names, in order of appearance; else numbers.
  bool names_itself = false;  ///< Headings and legends show its fields alone.
  bool is_measured = false;   ///< Known only once the cells are drawn.
  bool least_is_best = false;
  Scale scale = Scale::linear;
  std::map<std::string, std::string> field_labels;  ///< What fields are called; others as they are.
};

/// Only rows whose field in `column` is one of `fields` count.
struct ChartFilter {
  ChartColumn column;
  std::vector<std::string> fields;
};

struct Chart {
  std::string name;  ///< Stem of its files: letters a to z, digits, '_' and '-'.
  std::string title;
  std::string study;  ///< The study's title.
  ChartKind kind = ChartKind::lines;
  ChartColumn x;
  std::vector<ChartColumn> y;        ///< At least one; of a heat map exactly one: its rows.
  std::optional<ChartColumn> value;  ///< Of a heat map: what its cells show.
  std::optional<ChartColumn> by;     ///< A curve for each of its values.
  std::optional<ChartColumn> panel;  ///< A small chart for each of its values.
  std::optional<ChartColumn>
      best_of;                        ///< Of the rows that share x, by and panel, only the best in it counts.
  bool best_of_least = false;         ///< The best in `best_of` is the least.
  bool mark_least = false;            ///< The cell that a heat map marks is the least.
  std::optional<double> mark_within;  ///< It also marks the cells that are within so much of the best.
  std::vector<ChartFilter> where;
  std::string x_label, y_label, value_label;
  Scale scale_x = Scale::linear, scale_y = Scale::linear;  ///< Of a chart of lines.
  std::optional<double> y_from, y_to;
  std::string table = "data.csv";  ///< The file beside the charts' folder that holds the table.
};

/// Checks what the cells of a study decide before they are drawn: `planned` holds the columns that are not
/// measured. Errors (input, without a place): too many curves, panels or cells, several rows for one point.
void check_chart(const Chart& chart, const CsvTable& planned);

/// The script that draws NAME.svg and NAME.png beside itself. It reads the table's file where gnuplot can
/// pick the rows, else it holds the data. Errors (input, as `check_chart`; work: a column that is not there).
std::string chart_script(const Chart& chart, const CsvTable& table);

}  // namespace inkbench
