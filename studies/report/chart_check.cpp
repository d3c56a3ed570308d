// SPDX-License-Identifier: MIT
// What can be said against a chart before any cell is drawn.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"
#include "studies/report/chart_data.h"

namespace inkbench {
namespace {

bool is_measured(const std::optional<ChartColumn>& column) {
  return column && column->is_measured;
}

/// The columns that must tell points apart, by name.
std::vector<std::string> telling_columns(const Chart& chart) {
  std::vector<std::string> names{chart.x.name};
  if (chart.kind == ChartKind::heatmap) names.push_back(chart.y.front().name);
  if (chart.by) names.push_back(chart.by->name);
  if (chart.panel) names.push_back(chart.panel->name);
  return names;
}

/// Errors (input): two rows that stand at the same place.
void check_places(const Chart& chart, const CsvTable& planned, const std::vector<size_t>& rows) {
  const std::vector<std::string> names = telling_columns(chart);
  std::map<std::vector<std::string>, size_t> seen;
  for (const size_t row : rows) {
    std::vector<std::string> fields;
    for (const std::string& name : names) fields.push_back(planned.rows[row][planned.column(name)]);
    const auto [entry, is_new] = seen.try_emplace(fields, row);
    if (is_new) continue;
    for (size_t i = 0; i < names.size(); ++i) fields[i] = names[i] + " = " + fields[i];
    throw input_error("",
                      fmt::format("cells {} and {} stand at the same place ({})", entry->second + 1, row + 1,
                                  join(fields, ", ")),
                      chart.kind == ChartKind::lines
                          ? "tell them apart with by or panel, or choose with where or best_of"
                          : "tell them apart with panel, or choose with where or best_of");
  }
}

}  // namespace

void check_chart(const Chart& chart, const CsvTable& planned) {
  // Measured columns are empty here: what they choose cannot be told yet.
  Chart known = chart;
  known.best_of.reset();
  std::erase_if(known.where, [](const ChartFilter& filter) { return filter.column.is_measured; });
  const std::vector<size_t> rows = chosen_rows(known, planned);
  if (rows.empty()) throw input_error("", "no cell passes where", "leave some of it out");
  if (chart.kind == ChartKind::lines) {
    line_data(known, planned);
  } else {
    heat_data(known, planned);
  }
  const bool chooses_later = chart.best_of || known.where.size() != chart.where.size() ||
                             chart.x.is_measured || is_measured(chart.by) || is_measured(chart.panel);
  if (!chooses_later) check_places(chart, planned, rows);
}

}  // namespace inkbench
