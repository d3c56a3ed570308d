// SPDX-License-Identifier: MIT
#include "studies/sweep/chart_spec.h"

#include <set>

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"
#include "pipeline/params/toml_reader.h"
#include "studies/sweep/chart_table.h"
#include "studies/sweep/data_columns.h"

namespace inkbench {
namespace {

constexpr size_t kMostPlanned = 10'000;  // Cells beyond which a chart is checked only when it is drawn.

void check_filters(const Chart& chart, const CsvTable& planned) {
  for (const ChartFilter& filter : chart.where) {
    if (filter.column.is_measured) continue;
    const size_t column = planned.column(filter.column.name);
    std::set<std::string> known;
    for (const std::vector<std::string>& row : planned.rows) known.insert(row[column]);
    for (const std::string& field : filter.fields) {
      if (known.contains(field)) continue;
      const std::vector<std::string> choices(known.begin(), known.end());
      throw input_error("", "no cell has " + filter.column.name + " = " + field, suggest(field, choices));
    }
  }
}

void check_name(const Chart& chart, const std::vector<Chart>& others) {
  for (const Chart& other : others) {
    if (other.name == chart.name)
      throw input_error("", "a second chart of that name", "give it another one: name = \"...\"");
  }
}

}  // namespace

std::vector<Chart> read_charts(const TomlNode& document, const StudySpec& spec) {
  const TomlReader toml(spec.path.string());
  const std::vector<const TomlNode*> tables = toml.tables(document, "chart");
  if (tables.empty()) return {};
  const bool is_planned = cell_count(spec) <= kMostPlanned;
  const CsvTable planned = is_planned ? planned_table(spec) : CsvTable{};
  std::vector<Chart> charts;
  for (const TomlNode* table : tables) {
    Chart chart = read_chart(*table, spec);
    try {
      check_name(chart, charts);
      if (is_planned) check_filters(chart, planned);
      if (is_planned) check_chart(chart, planned);
    } catch (const Error& error) {
      throw input_error(toml.at(*table), "chart " + chart.name + ": " + error.what());
    }
    charts.push_back(std::move(chart));
  }
  return charts;
}

}  // namespace inkbench
