// SPDX-License-Identifier: MIT
#include "studies/sweep/spec_axes.h"

#include <fmt/format.h>

#include <cmath>

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"
#include "pipeline/params/toml_value.h"
#include "studies/sweep/labels.h"

namespace inkbench {
namespace {

constexpr int kMaxAxisCount = 1'000'000;

class AxesReader {
 public:
  explicit AxesReader(const StudySpec& spec)
      : path_(spec.path), toml_(spec.path.string()), base_(spec.base) {}

  std::vector<Axis> read(const TomlNode& document) {
    const std::vector<const TomlNode*> found = toml_.tables(document, "axis");
    if (found.empty() && document.find("axis") != nullptr)
      throw input_error(toml_.at(*document.find("axis")), "an empty list of axes");
    for (const TomlNode* table : found) axes_.push_back(axis(*table));
    if (axes_.size() > 3)
      throw input_error(path_.string(), fmt::format("has {} axes", axes_.size()),
                        "at most three: columns, rows, pages");
    add_labels(found);
    return std::move(axes_);
  }

 private:
  void add_labels(const std::vector<const TomlNode*>& tables) {
    std::vector<std::string> keys;
    for (const Axis& axis : axes_) keys.push_back(axis.key);
    const std::vector<std::string> short_keys = key_labels(keys);
    for (size_t i = 0; i < axes_.size(); ++i) {
      axes_[i].short_key = short_keys[i];
      axes_[i].label = toml_.text_entry(*tables[i], "label", short_keys[i]);
      axes_[i].value_labels = label_texts(axes_[i].values);
    }
  }

  Axis axis(const TomlNode& table) {
    toml_.check_keys(table, {"key", "values", "label", "from", "to", "count", "scale"});
    const TomlNode* key = table.find("key");
    if (key == nullptr)
      throw input_error(toml_.at(table), "an [[axis]] without a key",
                        "give it one: key = \"combine.k_depth\"");
    Axis axis;
    axis.key = toml_.text_of(*key, "key");
    const Param param = find_param(base_, axis.key, toml_.at(*key));
    for (const Axis& other : axes_) {
      if (param.overlaps(find_param(base_, other.key, toml_.at(*key))))
        throw input_error(toml_.at(*key), "a second axis over " + other.key, "each axis needs another key");
    }
    axis.values = table.find("values") != nullptr ? listed_values(table, param) : range_values(table, param);
    return axis;
  }

  std::vector<Value> listed_values(const TomlNode& table, const Param& param) const {
    const TomlNode& list = *table.find("values");
    for (const char* key : {"from", "to", "count", "scale"}) {
      if (const TomlNode* other = table.find(key)) {
        throw input_error(toml_.at(*other), std::string("both values and ") + key,
                          "give values, or from, to and count");
      }
    }
    if (toml_.items_of(list, "values").empty())
      throw input_error(toml_.at(list), "the axis over " + param.key + " has no values", "list at least one");
    std::vector<Value> values;
    for (const TomlNode& item : list.items)
      values.push_back(checked(
          param, value_from_toml(param, item, toml_.at(item), path_.parent_path().string()), toml_.at(item)));
    return values;
  }

  static Value checked(const Param& param, const Value& value, const std::string& where) {
    check_value(*param.field, param.key, value, where);
    return value;
  }

  double number_entry(const TomlNode& table, const std::string& key) const {
    const TomlNode* node = table.find(key);
    if (node == nullptr)
      throw input_error(toml_.at(table), "the axis has no values and no " + key,
                        "give values, or from, to and count");
    return toml_.number_of(*node, key);
  }

  std::vector<Value> range_values(const TomlNode& table, const Param& param) const {
    const double from = number_entry(table, "from");
    const double to = number_entry(table, "to");
    const double count = number_entry(table, "count");
    const bool log = scale_entry(toml_, table, param.field->scale) == Scale::log;
    if (!param.is_number()) {
      throw input_error(toml_.at(table),
                        "from and to need a number, and " + param.key + " is a " +
                            std::string(type_name(param.field->type)),
                        "give values instead");
    }
    if (count < 1 || count > kMaxAxisCount || count != std::floor(count)) {
      throw input_error(toml_.at(*table.find("count")), "count = " + shortest(count),
                        "it must be a whole number from 1 to " + with_commas(kMaxAxisCount));
    }
    for (const double end : {from, to}) checked(param, static_cast<float>(end), toml_.at(table));
    if (log && (from <= 0 || to <= 0))
      throw input_error(toml_.at(table), "a log axis from " + shortest(from) + " to " + shortest(to),
                        "both must be above 0");
    std::vector<Value> values;
    for (int i = 0; i < static_cast<int>(count); ++i) {
      const double t = count > 1 ? i / (count - 1) : 0.0;
      const double number = t == 1.0 ? to : log ? from * std::pow(to / from, t) : from + (to - from) * t;
      const Value value = param.field->type == FieldType::integer
                              ? Value(static_cast<int>(std::lround(number)))
                              : Value(static_cast<float>(number));
      if (values.empty() || values.back() != value) values.push_back(checked(param, value, toml_.at(table)));
    }
    return values;
  }

  std::filesystem::path path_;
  TomlReader toml_;
  Settings base_;
  std::vector<Axis> axes_;
};

}  // namespace

std::vector<Axis> read_axes(const TomlNode& document, const StudySpec& spec) {
  return AxesReader(spec).read(document);
}

Scale scale_entry(const TomlReader& toml, const TomlNode& table, Scale usual) {
  const TomlNode* node = table.find("scale");
  if (node == nullptr) return usual;
  const std::string scale = toml.text_of(*node, "scale");
  if (scale != "linear" && scale != "log")
    throw input_error(toml.at(*node), "scale is \"" + scale + "\"", "one of: linear, log");
  return scale == "log" ? Scale::log : Scale::linear;
}

}  // namespace inkbench
