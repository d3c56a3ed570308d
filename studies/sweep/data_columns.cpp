// SPDX-License-Identifier: MIT
#include "studies/sweep/data_columns.h"

#include <algorithm>

#include "studies/sweep/number_columns.h"

namespace inkbench {
namespace {

ChartColumn measure_column(const Measure& measure) {
  return {.name = measure.key,
          .label = measure.label,
          .unit = measure.unit,
          .is_text = measure.kind == MeasureKind::flag,
          .is_measured = true,
          .least_is_best = measure.better == Better::less,
          .scale = measure.scale};
}

ChartColumn varied_column(const StudySpec& spec, const Settings& settings, const std::string& key) {
  const ConstParam param = find_param(settings, key, key);
  ChartColumn column{
      .name = key, .label = key.substr(key.rfind('.') + 1), .unit = std::string(param.field->unit)};
  for (const Axis& axis : spec.axes) {
    if (axis.key == key) column.label = axis.label;
  }
  column.is_text = !param.is_number();
  column.scale = param.field->scale;
  if (key == "mesh.faces") column.zero = "as loaded";
  return column;
}

}  // namespace

std::vector<std::string> varied_keys(const StudySpec& spec) {
  std::vector<std::string> keys;
  for (const Axis& axis : spec.axes) keys.push_back(axis.key);
  for (const NamedSet& variant : spec.variants) {
    for (const Assignment& assignment : variant.set) {
      if (std::find(keys.begin(), keys.end(), assignment.key) == keys.end()) keys.push_back(assignment.key);
    }
  }
  return keys;
}

std::string field_text(const Value& value) {
  const auto* text = std::get_if<std::string>(&value);
  return text != nullptr ? *text : to_text(value);
}

std::vector<ChartColumn> chart_columns(const StudySpec& spec) {
  std::vector<ChartColumn> columns{{.name = "cell", .label = "cell"}};
  if (!spec.variants.empty())
    columns.push_back({.name = "variant", .label = "variant", .is_text = true, .names_itself = true});
  const Settings& settings = spec.base;
  for (const std::string& key : varied_keys(spec)) columns.push_back(varied_column(spec, settings, key));
  for (const Measure* measure : study_measures(spec)) columns.push_back(measure_column(*measure));
  return columns;
}

CsvTable planned_table(const StudySpec& spec) {
  CsvTable table;
  for (const ChartColumn& column : chart_columns(spec)) table.columns.push_back(column.name);
  const std::vector<std::string> keys = varied_keys(spec);
  for (size_t i = 0; i < cell_count(spec); ++i) {
    const Cell cell = make_cell(spec, i);
    Settings settings = cell_settings(spec, cell);
    std::vector<std::string> row{std::to_string(i + 1)};
    if (!spec.variants.empty()) row.push_back(cell.variant);
    for (const std::string& key : keys) row.push_back(field_text(find_param(settings, key, key).value()));
    row.resize(table.columns.size());
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace inkbench
