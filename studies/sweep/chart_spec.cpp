#include "studies/sweep/chart_spec.h"

#include <algorithm>
#include <set>

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"
#include "studies/sweep/chart_table.h"
#include "studies/sweep/data_columns.h"

namespace inkbench {
namespace {

constexpr size_t kMostPlanned = 50'000;  // Cells beyond which a chart is checked only when it is drawn.

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

/// The tables of [[chart]].
const std::vector<TomlNode>& chart_tables(const TomlNode& list, const std::string& where) {
  const auto is_table = [](const TomlNode& item) { return item.is_table(); };
  if (!list.is_array() || !std::all_of(list.items.begin(), list.items.end(), is_table))
    throw input_error(where, "chart is " + list.kind_name(), "it must be tables: [[chart]]");
  return list.items;
}

}  // namespace

std::vector<Chart> read_charts(const TomlNode& document, const StudySpec& spec) {
  const TomlNode* list = document.find("chart");
  if (list == nullptr) return {};
  const auto place = [&](const TomlNode& node) {
    return spec.path.string() + ":" + std::to_string(node.line);
  };
  const bool is_planned = cell_count(spec) <= kMostPlanned;
  const CsvTable planned = is_planned ? planned_table(spec) : CsvTable{};
  std::vector<Chart> charts;
  for (const TomlNode& table : chart_tables(*list, place(*list))) {
    Chart chart = read_chart(table, spec);
    try {
      check_name(chart, charts);
      if (is_planned) check_filters(chart, planned);
      if (is_planned) check_chart(chart, planned);
    } catch (const Error& error) {
      throw input_error(place(table), "chart " + chart.name + ": " + error.what());
    }
    charts.push_back(std::move(chart));
  }
  return charts;
}

}  // namespace inkbench
