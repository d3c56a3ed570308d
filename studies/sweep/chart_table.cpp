// SPDX-License-Identifier: MIT
#include "studies/sweep/chart_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"
#include "pipeline/params/toml_reader.h"
#include "pipeline/params/toml_value.h"
#include "studies/report/chart_text.h"
#include "studies/sweep/data_columns.h"
#include "studies/sweep/number_columns.h"

namespace inkbench {
namespace {

constexpr size_t kLongestName = 64;

const std::vector<std::string> kCommonKeys{"name",  "title", "kind",    "x",       "y",      "panel",
                                           "where", "best",  "best_of", "x_label", "y_label"};
const std::vector<std::string> kLinesKeys{"by", "scale_x", "scale_y", "y_from", "y_to"};
const std::vector<std::string> kHeatmapKeys{"value", "value_label"};

bool holds(const std::vector<std::string>& list, const std::string& text) {
  return std::find(list.begin(), list.end(), text) != list.end();
}

std::vector<std::string> together(std::vector<std::string> a, const std::vector<std::string>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// "F1 over k & faces" -> "f1_over_k_faces".
std::string name_from(const std::string& title) {
  std::string name;
  for (const char c : title) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (is_letter) name += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    if (!is_letter && !name.empty() && name.back() != '_') name += '_';
  }
  name.resize(std::min(name.size(), kLongestName));
  while (!name.empty() && name.back() == '_') name.pop_back();
  return name.empty() ? "chart" : name;
}

/// Reading one [[chart]].
class ChartReader {
 public:
  ChartReader(const TomlNode& table, const StudySpec& spec)
      : table_(table),
        spec_(spec),
        toml_(spec.path.string()),
        settings_(spec.base),
        columns_(chart_columns(spec)) {}

  Chart read() {
    chart_.study = spec_.title;
    read_kind();
    check_keys();
    read_columns();
    read_best();
    if (const TomlNode* where = table_.find("where")) read_where(*where, "");
    read_texts();
    if (chart_.kind == ChartKind::lines) read_scales();
    return std::move(chart_);
  }

 private:
  [[noreturn]] void refuse(const TomlNode& node, const std::string& what, const std::string& expected) const {
    throw input_error(toml_.at(node), what, expected);
  }

  /// The place of the entry's text in a list of choices.
  size_t choice(const std::string& key, const std::vector<std::string>& choices, size_t fallback) const {
    const TomlNode* node = table_.find(key);
    if (node == nullptr) return fallback;
    const auto found = std::find(choices.begin(), choices.end(), toml_.text_of(*node, key));
    if (found == choices.end())
      refuse(*node, key + " is \"" + node->text + "\"", "one of: " + join(choices, ", "));
    return static_cast<size_t>(found - choices.begin());
  }

  void read_kind() {
    chart_.kind = choice("kind", {"lines", "heatmap"}, 0) == 0 ? ChartKind::lines : ChartKind::heatmap;
  }

  void check_keys() const {
    const bool is_lines = chart_.kind == ChartKind::lines;
    const std::vector<std::string> known = together(kCommonKeys, is_lines ? kLinesKeys : kHeatmapKeys);
    for (const auto& [key, node] : table_.entries) {
      if (holds(known, key)) continue;
      if (holds(is_lines ? kHeatmapKeys : kLinesKeys, key))
        refuse(node, key + " is not for " + (is_lines ? "a chart of lines" : "a heat map"),
               is_lines ? "add kind = \"heatmap\", or leave it out" : "leave it out");
      refuse(node, "unknown entry '" + key + "'", suggest(key, known));
    }
  }

  ChartColumn column_named(const TomlNode& node, const std::string& name) const {
    std::vector<std::string> names;
    for (const ChartColumn& column : columns_) {
      if (column.name == name) return column;
      names.push_back(column.name);
    }
    const std::string_view new_name = renamed_measure(name);
    if (!new_name.empty())
      refuse(node, "the measure '" + name + "' has another name now",
             "write \"" + std::string(new_name) + "\"");
    const bool is_measure = holds(known_measures(), name);
    refuse(node, "data.csv will have no column '" + name + "'",
           is_measure ? "add it to the study's measure" : suggest(name, names));
  }

  ChartColumn column(const TomlNode& node, const std::string& key) const {
    return column_named(node, toml_.text_of(node, key));
  }

  ChartColumn number_column(const TomlNode& node, const std::string& key) const {
    ChartColumn result = column(node, key);
    if (result.is_text)
      refuse(node, key + " is \"" + result.name + "\", which holds no numbers",
             "a column of numbers is needed");
    return result;
  }

  const TomlNode& needed(const std::string& key) const {
    const TomlNode* node = table_.find(key);
    if (node == nullptr)
      refuse(table_, "a [[chart]] without " + key,
             "name a column of data.csv: " + key + " = \"" +
                 (key == "x" ? columns_[std::min<size_t>(1, columns_.size() - 1)].name : "ink") + "\"");
    return *node;
  }

  void read_columns() {
    chart_.x = column(needed("x"), "x");
    if (chart_.kind == ChartKind::lines) {
      read_lines();
    } else {
      chart_.y = {column(needed("y"), "y")};
      chart_.value = number_column(needed("value"), "value");
      for (const char* key : {"x", "y"}) refuse_measured(key);
    }
    if (const TomlNode* node = table_.find("panel")) chart_.panel = column(*node, "panel");
    check_columns_differ();
  }

  void read_lines() {
    const TomlNode& y = needed("y");
    if (y.is_array() && y.items.empty()) refuse(y, "y is an empty list", "name at least one column");
    if (!y.is_array()) chart_.y = {number_column(y, "y")};
    for (const TomlNode& item : y.items) {
      const ChartColumn next = number_column(item, "y");
      for (const ChartColumn& other : chart_.y) {
        if (other.name == next.name) refuse(item, "y names " + next.name + " twice", "name each column once");
      }
      chart_.y.push_back(next);
    }
    if (const TomlNode* node = table_.find("by")) chart_.by = column(*node, "by");
  }

  void refuse_measured(const std::string& key) const {
    const ChartColumn& column = key == "x" ? chart_.x : chart_.y.front();
    if (column.is_measured)
      refuse(*table_.find(key), key + " of a heat map is " + column.name + ", which is measured",
             "it needs a column that the study varies");
  }

  void check_columns_differ() const {
    std::vector<std::pair<std::string, std::string>> seen{{chart_.x.name, "x"}};
    const auto check = [&](const std::string& key, const ChartColumn& column) {
      for (const auto& [name, other] : seen) {
        if (name == column.name)
          refuse(*table_.find(key), key + " and " + other + " are both " + name, "they must differ");
      }
      seen.emplace_back(column.name, key);
    };
    if (chart_.kind == ChartKind::heatmap) check("y", chart_.y.front());
    if (chart_.by) check("by", *chart_.by);
    if (chart_.panel) check("panel", *chart_.panel);
  }

  void read_best() {
    if (const TomlNode* node = table_.find("best_of")) chart_.best_of = number_column(*node, "best_of");
    const TomlNode* best = table_.find("best");
    if (best != nullptr && chart_.kind == ChartKind::lines && !chart_.best_of)
      refuse(*best, "best without best_of", "name a column: best_of = \"ink\"");
    const std::vector<std::string> choices{"greatest", "least"};
    if (chart_.best_of)
      chart_.best_of_least = choice("best", choices, chart_.best_of->least_is_best ? 1 : 0) == 1;
    if (chart_.value) chart_.mark_least = choice("best", choices, chart_.value->least_is_best ? 1 : 0) == 1;
  }

  /// `where = { mesh.normals = "flat" }`: a dotted key is a table within a table.
  void read_where(const TomlNode& table, const std::string& prefix) {
    if (!table.is_table())
      refuse(table, "where is " + table.kind_name(), "it must be a table: { mesh.normals = \"flat\" }");
    for (const auto& [key, node] : table.entries) {
      const std::string name = prefix + key;
      if (node.is_table()) {
        read_where(node, name + ".");
      } else {
        read_filter(column_named(node, name), node);
      }
    }
  }

  void read_filter(const ChartColumn& column, const TomlNode& node) {
    ChartFilter filter{column, {}};
    if (!is_list_of_values(column, node)) filter.fields.push_back(field_of(column, node));
    if (filter.fields.empty()) {
      for (const TomlNode& item : node.items) filter.fields.push_back(field_of(column, item));
    }
    if (filter.fields.empty()) refuse(node, "where lists no value of " + column.name, "list at least one");
    chart_.where.push_back(std::move(filter));
  }

  bool is_varied(const ChartColumn& column) const {
    return !column.is_measured && column.name != "cell" && column.name != "variant";
  }

  /// Three numbers are one value of a vector, and three values of anything else.
  bool is_list_of_values(const ChartColumn& column, const TomlNode& node) {
    if (!node.is_array()) return false;
    if (!is_varied(column) || node.items.empty()) return true;
    const Param param = find_param(settings_, column.name, toml_.at(node));
    const FieldType type = param.field->type;
    const bool takes_list = type == FieldType::vector || type == FieldType::colour || type == FieldType::ramp;
    return !takes_list || param.component >= 0 || node.items.front().is_array();
  }

  /// The value as it will stand in data.csv.
  std::string field_of(const ChartColumn& column, const TomlNode& node) {
    if (is_varied(column)) {
      const Param param = find_param(settings_, column.name, toml_.at(node));
      param.set(value_from_toml(param, node, toml_.at(node), spec_.path.parent_path().string()),
                toml_.at(node));
      return field_text(spec_, param);
    }
    switch (node.kind) {
      case TomlNode::Kind::boolean:
        return node.boolean ? "true" : "false";
      case TomlNode::Kind::integer:
        return std::to_string(node.integer);
      case TomlNode::Kind::real:
        return shortest(node.real);
      case TomlNode::Kind::text:
        return node.text;
      default:
        refuse(node, column.name + " is " + node.kind_name() + " in where",
               "it must be a value, or a list of values");
    }
  }

  void read_texts() {
    chart_.x_label = toml_.text_entry(table_, "x_label", axis_text(chart_.x));
    chart_.y_label = toml_.text_entry(table_, "y_label", default_y_label());
    if (chart_.value) chart_.value_label = toml_.text_entry(table_, "value_label", axis_text(*chart_.value));
    chart_.title = toml_.text_entry(table_, "title", default_title());
    chart_.name = toml_.text_entry(table_, "name", name_from(chart_.title));
    const bool is_name =
        !chart_.name.empty() && chart_.name.size() <= kLongestName &&
        chart_.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_-") == std::string::npos;
    if (!is_name)
      refuse(*table_.find("name"), "name is \"" + chart_.name + "\"",
             fmt::format("it names files: 1 to {} of a to z, 0 to 9, _ and -", kLongestName));
  }

  std::string default_y_label() const {
    if (chart_.y.size() == 1) return axis_text(chart_.y.front());
    const std::string& unit = chart_.y.front().unit;
    const bool is_common =
        std::all_of(chart_.y.begin(), chart_.y.end(), [&](const ChartColumn& y) { return y.unit == unit; });
    return is_common ? unit : "";
  }

  std::string default_title() const {
    std::vector<std::string> labels;
    for (const ChartColumn& y : chart_.y) labels.push_back(y.label);
    if (chart_.kind == ChartKind::lines) return join(labels, ", ") + " against " + chart_.x.label;
    return chart_.value->label + " over " + chart_.x.label + " and " + chart_.y.front().label;
  }

  std::optional<double> number_entry(const std::string& key) const {
    const TomlNode* node = table_.find(key);
    return node == nullptr ? std::nullopt : std::optional(toml_.number_of(*node, key));
  }

  void read_scales() {
    const bool all_log = std::all_of(chart_.y.begin(), chart_.y.end(),
                                     [](const ChartColumn& y) { return y.scale == Scale::log; });
    const std::vector<std::string> choices{"linear", "log"};
    if (chart_.x.is_text && table_.find("scale_x") != nullptr)
      refuse(*table_.find("scale_x"), "scale_x over " + chart_.x.name + ", which holds names",
             "leave it out");
    chart_.scale_x =
        choice("scale_x", choices, chart_.x.scale == Scale::log ? 1 : 0) == 1 ? Scale::log : Scale::linear;
    chart_.scale_y = choice("scale_y", choices, all_log ? 1 : 0) == 1 ? Scale::log : Scale::linear;
    chart_.y_from = number_entry("y_from");
    chart_.y_to = number_entry("y_to");
    for (const char* key : {"y_from", "y_to"}) {
      const TomlNode* node = table_.find(key);
      if (node != nullptr && chart_.scale_y == Scale::log && *number_entry(key) <= 0)
        refuse(*node, std::string(key) + " = " + shortest(*number_entry(key)) + " on a log axis",
               "it must be above 0");
    }
    if (chart_.y_from && chart_.y_to && *chart_.y_from >= *chart_.y_to)
      refuse(*table_.find("y_to"), "y_to = " + shortest(*chart_.y_to), "it must be above y_from");
  }

  const TomlNode& table_;
  const StudySpec& spec_;
  TomlReader toml_;
  Settings settings_;
  std::vector<ChartColumn> columns_;
  Chart chart_;
};

}  // namespace

Chart read_chart(const TomlNode& table, const StudySpec& spec) {
  return ChartReader(table, spec).read();
}

}  // namespace inkbench
