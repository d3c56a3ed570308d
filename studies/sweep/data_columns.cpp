#include "studies/sweep/data_columns.h"

#include <algorithm>
#include <array>
#include <map>

#include "studies/sweep/number_columns.h"

namespace inkbench {
namespace {

/// What is not to be read off a measure's name.
struct MeasureText {
  const char* label;
  const char* unit = "";
};

const std::map<std::string, MeasureText>& measure_texts() {
  static const std::map<std::string, MeasureText> kTexts{
      {"faces", {"triangles drawn"}},
      {"ink", {"ink", "share of pixels"}},
      {"ink_px", {"ink", "px"}},
      {"f1_t1", {"f1 at 1 px"}},
      {"f1_diag", {"f1 at 0.75 % of the diagonal"}},
      {"chamfer", {"chamfer distance", "px"}},
      {"hd95", {"95 % Hausdorff distance", "px"}},
      {"baddeley", {"Baddeley distance", "px"}},
      {"breaks_per_100px", {"breaks per 100 px"}},
      {"ends_per_100px", {"ends per 100 px"}},
      {"thickness_cov", {"thickness, deviation / mean"}},
      {"f1_end_to_end", {"f1 end to end"}},
      {"matched", {"matched pixels"}},
      {"predicted", {"predicted pixels"}},
      {"referenced", {"referenced pixels"}},
  };
  return kTexts;
}

/// Measures of which a good drawing has little.
constexpr std::array<std::string_view, 9> kLeastIsBest{"chamfer",          "hd95",          "baddeley",
                                                       "breaks_per_100px", "mean_gap_px",   "ends_per_100px",
                                                       "jaggedness_px",    "thickness_cov", "internal_new"};

ChartColumn measure_column(const std::string& name) {
  ChartColumn column{.name = name, .label = name, .is_text = name == "empty", .is_measured = true};
  const auto text = measure_texts().find(name);
  if (text != measure_texts().end()) {
    column.label = text->second.label;
    column.unit = text->second.unit;
  } else if (name.ends_with("_px")) {
    column.label.resize(name.size() - 3);
    column.unit = "px";
  }
  std::replace(column.label.begin(), column.label.end(), '_', ' ');
  if (name == "faces") column.scale = Scale::log;
  column.least_is_best = std::find(kLeastIsBest.begin(), kLeastIsBest.end(), name) != kLeastIsBest.end();
  return column;
}

ChartColumn varied_column(const StudySpec& spec, Settings& settings, const std::string& key) {
  const Param param = find_param(settings, key, key);
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
  Settings settings = spec.base;
  for (const std::string& key : varied_keys(spec)) columns.push_back(varied_column(spec, settings, key));
  for (const std::string& name : number_columns(spec)) columns.push_back(measure_column(name));
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
