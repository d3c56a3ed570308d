// SPDX-License-Identifier: MIT
#include "pipeline/params/toml_value.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <optional>

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

using Kind = TomlNode::Kind;

std::optional<float> as_real(const TomlNode& node) {
  if (node.kind == Kind::integer) return static_cast<float>(node.integer);
  if (node.kind == Kind::real) return static_cast<float>(node.real);
  return std::nullopt;
}

std::optional<int> as_integer(const TomlNode& node) {
  const bool whole =
      node.kind == Kind::real && node.real == std::floor(node.real) && std::abs(node.real) < 2e9;
  if (whole) return static_cast<int>(node.real);
  if (node.kind != Kind::integer || node.integer < INT32_MIN || node.integer > INT32_MAX) return std::nullopt;
  return static_cast<int>(node.integer);
}

std::optional<glm::vec3> hex_colour(const TomlNode& node) {
  if (!node.is_text() || node.text.size() != 7 || node.text[0] != '#') return std::nullopt;
  if (node.text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos) return std::nullopt;
  const unsigned long rgb = std::stoul(node.text.substr(1), nullptr, 16);
  return glm::vec3((rgb >> 16) & 255U, (rgb >> 8) & 255U, rgb & 255U) / 255.0F;
}

std::optional<glm::vec3> as_vector(const TomlNode& node, bool is_colour) {
  if (const std::optional<float> all = as_real(node)) return glm::vec3(*all);
  if (is_colour) {
    if (const std::optional<glm::vec3> colour = hex_colour(node)) return colour;
  }
  if (!node.is_array() || node.items.size() != 3) return std::nullopt;
  glm::vec3 result;
  for (int i = 0; i < 3; ++i) {
    const std::optional<float> component = as_real(node.items[i]);
    if (!component) return std::nullopt;
    result[i] = *component;
  }
  return result;
}

std::string absolute_path(const std::string& text, const std::string& folder) {
  return std::filesystem::absolute(std::filesystem::path(folder) / text).lexically_normal().string();
}

std::optional<RampStop> as_stop(const TomlNode& node) {
  if (!node.is_table()) return std::nullopt;
  RampStop stop;
  bool has_position = false;
  bool has_colour = false;
  for (const auto& [key, entry] : node.entries) {
    const std::optional<float> number = as_real(entry);
    const std::optional<glm::vec3> colour = as_vector(entry, true);
    if (key == "position" && number) {
      stop.position = *number;
      has_position = true;
    } else if (key == "colour" && colour) {
      stop.colour = *colour;
      has_colour = true;
    } else if (key == "stepped" && entry.kind == Kind::boolean) {
      stop.stepped = entry.boolean;
    } else {
      return std::nullopt;
    }
  }
  return has_position && has_colour ? std::optional(stop) : std::nullopt;
}

std::optional<Ramp> as_ramp(const TomlNode& node, const std::string& folder) {
  Ramp ramp;
  if (node.is_text() && !node.text.empty()) {
    ramp.image = absolute_path(node.text, folder);
    return ramp;
  }
  if (!node.is_array() || node.items.empty()) return std::nullopt;
  for (const TomlNode& item : node.items) {
    const std::optional<RampStop> stop = as_stop(item);
    if (!stop) return std::nullopt;
    ramp.stops.push_back(*stop);
  }
  return ramp;
}

std::optional<Value> convert(const Field& field, int component, const TomlNode& node,
                             const std::string& folder) {
  const auto wrap = [](const auto& optional) {
    return optional ? std::optional<Value>(*optional) : std::nullopt;
  };
  if (component >= 0) return wrap(as_real(node));
  switch (field.type) {
    case FieldType::boolean:
      return node.kind == Kind::boolean ? std::optional<Value>(node.boolean) : std::nullopt;
    case FieldType::integer:
      return wrap(as_integer(node));
    case FieldType::real:
      return wrap(as_real(node));
    case FieldType::vector:
    case FieldType::colour:
      return wrap(as_vector(node, field.type == FieldType::colour));
    case FieldType::choice:
      return node.is_text() ? std::optional<Value>(node.text) : std::nullopt;
    case FieldType::text:
      if (!node.is_text()) return std::nullopt;
      if (!field.is_path || node.text.empty()) return Value(node.text);
      if (field.is_no_path != nullptr && field.is_no_path(node.text)) return Value(node.text);
      return Value(absolute_path(node.text, folder));
    case FieldType::ramp:
      return wrap(as_ramp(node, folder));
  }
  return std::nullopt;
}

/// A word without quotes as text. Errors (input): it is not UTF-8, so no TOML could hold it.
TomlNode bare_text(const Param& param, const std::string& word, const std::string& where) {
  try {
    return *parse_toml("value = " + to_text(Value(word)), where).find("value");
  } catch (const Error&) {
    throw input_error(where, param.key + " is not UTF-8 text");
  }
}

/// `Number`: int or float, shown as it is.
template <class Number>
void check_number(const Field& field, const std::string& key, Number number, const std::string& where) {
  const double value = number;
  if (std::isfinite(value) && value >= field.limits.low && value <= field.limits.high) return;
  // Limits are written as decimals and values are floats: a value that prints like the limit is the limit.
  const auto same = [&](double limit) { return static_cast<float>(number) == static_cast<float>(limit); };
  if (same(field.limits.low) || same(field.limits.high)) return;
  const int component = std::is_same_v<Number, float> ? 0 : -1;
  throw input_error(where, fmt::format("{} = {} is out of range", key, to_text(Value(number))),
                    "it must be " + accepted(field, component));
}

void check_choice(const Field& field, const std::string& key, const std::string& name,
                  const std::string& where) {
  std::vector<std::string> names(field.choices.begin(), field.choices.end());
  for (const std::string& choice : names) {
    if (choice == name) return;
  }
  throw input_error(where, key + " = \"" + name + "\" is not one of its choices",
                    "one of: " + join(names, ", "));
}

void check_ramp(const std::string& key, const Ramp& ramp, const std::string& where) {
  float last = 0.0F;
  for (const RampStop& stop : ramp.stops) {
    if (!(stop.position >= last && stop.position <= 1.0F)) {
      throw input_error(
          where, fmt::format("{} has a stop at {} after {}", key, shortest(stop.position), shortest(last)),
          "positions rise from 0 to 1");
    }
    last = stop.position;
    for (int i = 0; i < 3; ++i) {
      if (!(stop.colour[i] >= 0.0F && stop.colour[i] <= 1.0F)) {
        throw input_error(where, fmt::format("{} has a colour component {}", key, shortest(stop.colour[i])),
                          "components are from 0 to 1");
      }
    }
  }
}

}  // namespace

std::string accepted(const Field& field, int component) {
  const std::string range =
      fmt::format("from {} to {}{}{}", shortest(field.limits.low), shortest(field.limits.high),
                  field.unit.empty() ? "" : " ", field.unit);
  if (component >= 0) return "a number " + range;
  switch (field.type) {
    case FieldType::boolean:
      return "true or false";
    case FieldType::integer:
      return "a whole number " + range;
    case FieldType::real:
      return "a number " + range;
    case FieldType::vector:
      return "three numbers [x, y, z], each " + range;
    case FieldType::colour:
      return "a colour [red, green, blue], each " + range + ", or \"#rrggbb\"";
    case FieldType::choice:
      return "one of: " + join(std::vector<std::string>(field.choices.begin(), field.choices.end()), ", ");
    case FieldType::text:
      return field.is_path ? "the path of a file, as text" : "text";
    case FieldType::ramp:
      return "a list of stops {position = 0.5, colour = [1, 1, 1], stepped = true}, or the path of an image";
  }
  return "";
}

Value value_from_toml(const Param& param, const TomlNode& node, const std::string& where,
                      const std::string& folder) {
  if (const std::optional<Value> value = convert(*param.field, param.component, node, folder)) return *value;
  throw input_error(where, param.key + " is " + node.kind_name(),
                    "it must be " + accepted(*param.field, param.component));
}

Value value_from_text(const Param& param, const std::string& text, const std::string& where) {
  const std::string trimmed(trim(text));
  const FieldType type = param.field->type;
  const TomlNode bare = bare_text(param, trimmed, where);
  if (type == FieldType::choice && !trimmed.starts_with('"')) return value_from_toml(param, bare, where, ".");
  const bool is_list =
      trimmed.find(',') != std::string::npos && !trimmed.starts_with('[') && !trimmed.starts_with('"');
  const bool is_vector = type == FieldType::vector || type == FieldType::colour;
  TomlNode parsed;
  try {
    parsed = parse_toml("value = " + (is_list && is_vector ? "[" + trimmed + "]" : trimmed), where);
  } catch (const Error&) {
    if (type == FieldType::ramp && trimmed.starts_with('['))
      throw;  // a mistyped list of stops is no image's name
    return value_from_toml(param, bare, where, ".");
  }
  const TomlNode* node = parsed.entries.size() == 1 ? parsed.find("value") : nullptr;
  const bool wants_text = type == FieldType::text && node != nullptr && !node->is_text();
  return value_from_toml(param, node == nullptr || wants_text ? bare : *node, where, ".");
}

void check_value(const Field& field, const std::string& key, const Value& value, const std::string& where) {
  if (const auto* number = std::get_if<float>(&value)) check_number(field, key, *number, where);
  if (const auto* number = std::get_if<int>(&value)) check_number(field, key, *number, where);
  if (const auto* ramp = std::get_if<Ramp>(&value)) check_ramp(key, *ramp, where);
  if (const auto* vector = std::get_if<glm::vec3>(&value)) {
    for (int i = 0; i < 3; ++i) check_number(field, key, (*vector)[i], where);
  }
  if (field.type == FieldType::choice) check_choice(field, key, std::get<std::string>(value), where);
}

}  // namespace inkbench
