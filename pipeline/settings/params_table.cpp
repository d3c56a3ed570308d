// SPDX-License-Identifier: MIT
#include "pipeline/settings/params_table.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "pipeline/base/text.h"
#include "pipeline/settings/settings.h"

namespace inkbench {
namespace {

Settings one_of_each() {
  Settings settings;
  settings.models.emplace_back().name = "<name>";
  settings.lights.emplace_back().name = "<name>";
  return settings;
}

bool has_limits(const Field& field) {
  return field.limits.low != field.limits.high;
}

std::string_view scale_name(Scale scale) {
  return scale == Scale::log ? "log" : "linear";
}

std::string range_text(const Limits& limits) {
  return shortest(limits.low) + " to " + shortest(limits.high);
}

std::string allowed(const Field& field) {
  if (!field.choices.empty()) {
    return join(std::vector<std::string>(field.choices.begin(), field.choices.end()), ", ");
  }
  return has_limits(field) ? range_text(field.limits) : "";
}

std::string help_with_condition(const Field& field) {
  std::string help(field.help);
  if (!field.matters_when.empty()) help += fmt::format(" Matters when {}.", field.matters_when);
  return help;
}

std::string text_table(const Settings& settings) {
  std::string text;
  for (const ConstParamGroup& group : list_groups(settings)) {
    text += fmt::format("{}{}\n", text.empty() ? "" : "\n", group.description->title);
    for (const Field& field : group.description->fields) {
      const std::string key = group.prefix + "." + std::string(field.name);
      const std::string unit = field.unit.empty() ? "" : " " + std::string(field.unit);
      const std::string allowed_text = allowed(field).empty() ? "" : " (" + allowed(field) + ")";
      text += fmt::format("  {} = {}{}{}\n      {}\n", key, to_text(field.get(group.owner)), unit,
                          allowed_text, help_with_condition(field));
    }
  }
  return text;
}

std::string markdown_table(const Settings& settings) {
  std::string text;
  for (const ConstParamGroup& group : list_groups(settings)) {
    text += fmt::format(
        "{}### {}\n\n| key | type | default | allowed | unit | what it does |\n|---|---|---|---|---|---|\n",
        text.empty() ? "" : "\n", group.description->title);
    for (const Field& field : group.description->fields) {
      text += fmt::format("| `{}.{}` | {} | `{}` | {} | {} | {} |\n", group.prefix, field.name,
                          type_name(field.type), to_text(field.get(group.owner)), allowed(field), field.unit,
                          help_with_condition(field));
    }
  }
  return text;
}

std::string json_table(const Settings& settings) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ConstParamGroup& group : list_groups(settings)) {
    for (const Field& field : group.description->fields) {
      nlohmann::ordered_json entry{{"key", group.prefix + "." + std::string(field.name)},
                                   {"group", group.description->title},
                                   {"type", type_name(field.type)},
                                   {"default", to_text(field.get(group.owner))}};
      if (has_limits(field)) entry["limits"] = {field.limits.low, field.limits.high};
      if (has_limits(field)) entry["slider"] = {field.slider.low, field.slider.high};
      if (has_limits(field)) entry["scale"] = scale_name(field.scale);
      if (!field.choices.empty())
        entry["choices"] = std::vector<std::string>(field.choices.begin(), field.choices.end());
      entry["unit"] = field.unit;
      entry["matters_when"] = field.matters_when;
      entry["help"] = field.help;
      list.push_back(entry);
    }
  }
  return list.dump(2) + "\n";
}

}  // namespace

std::string params_table(TableFormat format) {
  const Settings settings = one_of_each();
  switch (format) {
    case TableFormat::text:
      return text_table(settings);
    case TableFormat::markdown:
      return markdown_table(settings);
    case TableFormat::json:
      return json_table(settings);
  }
  return "";
}

}  // namespace inkbench
