// SPDX-License-Identifier: MIT
#include "studies/sweep/data_columns.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>

#include "studies/sweep/labels.h"
#include "studies/sweep/number_columns.h"

namespace inkbench {
namespace {

namespace fs = std::filesystem;

ChartColumn measure_column(const Measure& measure) {
  return {.name = measure.key,
          .label = measure.label,
          .unit = measure.unit,
          .is_text = measure.kind == MeasureKind::flag,
          .is_measured = true,
          .least_is_best = measure.better == Better::less,
          .scale = measure.scale};
}

/// Relative to the spec's folder, unless it is none of a file or the way leads through the root.
std::string path_field(const StudySpec& spec, const std::string& path) {
  if (!fs::path(path).is_absolute()) return path;
  const fs::path folder = fs::absolute(spec.path).lexically_normal().parent_path();
  const fs::path way = fs::path(path).lexically_normal().lexically_relative(folder);
  const auto up = std::count(way.begin(), way.end(), fs::path(".."));
  const auto depth = std::distance(folder.begin(), folder.end()) - 1;  // the root is no step
  return way.empty() || up >= depth ? path : way.string();
}

/// All values of the key, each once: those of its axis, else the base's and the variants'.
std::vector<Value> values_of(const StudySpec& spec, const std::string& key) {
  for (const Axis& axis : spec.axes) {
    if (axis.key == key) return axis.values;
  }
  std::vector<Value> values{find_param(spec.base, key, key).value()};
  for (const NamedSet& variant : spec.variants) {
    for (const Assignment& assignment : variant.set) {
      const bool is_new =
          assignment.key == key && std::find(values.begin(), values.end(), assignment.value) == values.end();
      if (is_new) values.push_back(assignment.value);
    }
  }
  return values;
}

std::map<std::string, std::string> field_labels(const StudySpec& spec, const std::string& key) {
  const std::vector<Value> values = values_of(spec, key);
  const std::vector<std::string> labels = label_texts(values);
  Settings settings = spec.base;
  const Param param = find_param(settings, key, key);
  std::map<std::string, std::string> named;
  for (size_t i = 0; i < values.size(); ++i) {
    param.set(values[i], key);
    named.emplace(field_text(spec, param), labels[i]);
  }
  return named;
}

/// `label` is the key's among all that are varied.
ChartColumn varied_column(const StudySpec& spec, const std::string& key, const std::string& label) {
  const ConstParam param = find_param(spec.base, key, key);
  ChartColumn column{.name = key, .label = label, .unit = std::string(param.field->unit)};
  for (const Axis& axis : spec.axes) {
    if (axis.key == key && axis.label != axis.short_key) column.label = axis.label;
  }
  column.is_text = !param.is_number();
  if (param.field->is_path) column.field_labels = field_labels(spec, key);
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

std::string field_text(const StudySpec& spec, const ConstParam& param) {
  const Value value = param.value();
  if (const auto* text = std::get_if<std::string>(&value))
    return param.field->is_path ? path_field(spec, *text) : *text;
  if (const auto* ramp = std::get_if<Ramp>(&value); ramp != nullptr && !ramp->image.empty())
    return path_field(spec, ramp->image);
  return to_text(value);
}

std::vector<ChartColumn> chart_columns(const StudySpec& spec) {
  std::vector<ChartColumn> columns{{.name = "cell", .label = "cell"}};
  if (!spec.variants.empty())
    columns.push_back({.name = "variant", .label = "variant", .is_text = true, .names_itself = true});
  const std::vector<std::string> keys = varied_keys(spec), labels = key_labels(keys);
  for (size_t i = 0; i < keys.size(); ++i) columns.push_back(varied_column(spec, keys[i], labels[i]));
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
    for (const std::string& key : keys) row.push_back(field_text(spec, find_param(settings, key, key)));
    row.resize(table.columns.size());
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace inkbench
