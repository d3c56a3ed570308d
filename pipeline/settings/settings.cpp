// SPDX-License-Identifier: MIT
#include "pipeline/settings/settings.h"

#include <algorithm>
#include <optional>
#include <set>
#include <type_traits>

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"
#include "pipeline/params/toml_value.h"

namespace inkbench {
namespace {

int component_of(const std::string& key, const Field& field) {
  if (field.type != FieldType::vector && field.type != FieldType::colour) return -1;
  const size_t dot = key.rfind('.');
  const std::string_view name = std::string_view(key).substr(dot + 1);
  if (name.size() != 1) return -1;
  const size_t place = std::string_view("xyzrgb").find(name[0]);
  return place == std::string_view::npos ? -1 : static_cast<int>(place % 3);
}

/// The groups of the models and lights that `wanted(list, name)` names, and all others. `Owner`: void, or
/// const void for const settings.
template <class Owner, class AnySettings, class Wanted>
std::vector<ParamGroupOf<Owner>> groups_where(AnySettings& settings, const Wanted& wanted) {
  std::vector<ParamGroupOf<Owner>> groups;
  visit_groups(
      settings,
      [&](const std::string& prefix, auto& group) {
        groups.push_back({prefix, &std::remove_reference_t<decltype(group)>::description(), &group});
      },
      wanted);
  BroughtGroups::visit(settings.brought, [&](const Description& description, Owner* owner) {
    groups.push_back({std::string(description.group), &description, owner});
  });
  return groups;
}

bool all_names(std::string_view, const std::string&) {
  return true;
}

/// Looks only into the groups that the key can be in: a study looks up keys by the million, a scene may have
/// thousands of models.
template <class Owner, class AnySettings>
std::optional<ParamOf<Owner>> lookup(AnySettings& settings, const std::string& key) {
  const auto is_named = [&](std::string_view list, const std::string& name) {
    const size_t end = list.size() + 1 + name.size();
    return key.size() > end && key[end] == '.' && key.starts_with(list) &&
           key.compare(list.size() + 1, name.size(), name) == 0;
  };
  for (const ParamGroupOf<Owner>& group : groups_where<Owner>(settings, is_named)) {
    if (!key.starts_with(group.prefix) || key.size() <= group.prefix.size() ||
        key[group.prefix.size()] != '.')
      continue;
    const std::string_view rest = std::string_view(key).substr(group.prefix.size() + 1);
    for (const Field& field : group.description->fields) {
      if (rest == field.name) return ParamOf<Owner>{key, &field, group.owner, -1};
      const bool is_prefix = rest.size() == field.name.size() + 2 && rest.starts_with(field.name) &&
                             rest[field.name.size()] == '.';
      const int component = is_prefix ? component_of(key, field) : -1;
      if (component >= 0) return ParamOf<Owner>{key, &field, group.owner, component};
    }
  }
  return std::nullopt;
}

template <class Owner, class AnySettings>
std::vector<ParamOf<Owner>> params_of(AnySettings& settings) {
  std::vector<ParamOf<Owner>> params;
  for (const ParamGroupOf<Owner>& group : groups_where<Owner>(settings, all_names)) {
    for (const Field& field : group.description->fields) {
      params.push_back({group.prefix + "." + std::string(field.name), &field, group.owner, -1});
    }
  }
  return params;
}

template <class Item>
bool has_named(const std::vector<Item>& items, const std::string& name) {
  return std::any_of(items.begin(), items.end(), [&](const Item& item) { return item.name == name; });
}

/// For "model.NAME..." of a model that is not there: how one is written; else "".
std::string how_to_add(const Settings& settings, const std::string& key) {
  const std::vector<std::string> parts = split(key, '.');
  if (parts.size() < 2 || (parts[0] != "model" && parts[0] != "light")) return "";
  const bool is_there =
      parts[0] == "model" ? has_named(settings.models, parts[1]) : has_named(settings.lights, parts[1]);
  if (is_there) return "";
  return "there is no " + parts[0] + " '" + parts[1] + "'; a scene file adds one with [[" + parts[0] +
         "]] and name = \"" + parts[1] + "\" below it";
}

[[noreturn]] void throw_unknown(const Settings& settings, const std::string& key, const std::string& where) {
  std::vector<std::string> keys;
  for (const ConstParam& param : list_params(settings)) keys.push_back(param.key);
  std::string help = suggest(key, keys);
  const std::string how = how_to_add(settings, key);
  if (!how.empty()) help += (help.empty() ? "" : " ") + how;
  throw input_error(where, "unknown parameter '" + key + "'",
                    help.empty() ? "`inkbench params` lists them all" : help);
}

void check_names_differ(const Settings& settings) {
  std::set<std::string> names;
  for (const ModelParams& model : settings.models) {
    if (!names.insert(model.name).second)
      throw input_error("model", "two models are named '" + model.name + "'");
  }
  names.clear();
  for (const LightParams& light : settings.lights) {
    if (!names.insert(light.name).second)
      throw input_error("light", "two lights are named '" + light.name + "'");
  }
}

/// Whether a user's own words can be in it.
bool holds_text(const Field& field) {
  return field.type == FieldType::text || field.type == FieldType::ramp;
}

/// Metadata, manifests and scene files hold UTF-8 alone: another name would read back as that of another
/// file.
void check_texts(const Settings& settings) {
  for (const ConstParamGroup& group : list_groups(settings)) {
    for (const Field& field : group.description->fields) {
      if (!holds_text(field)) continue;
      const std::string text = to_text(field.get(group.owner));
      if (is_utf8(text)) continue;
      throw input_error(group.prefix + "." + std::string(field.name), "is not UTF-8: " + printable(text),
                        "rename the file or its folder");
    }
  }
}

}  // namespace

std::vector<ParamGroup> list_groups(Settings& settings) {
  return groups_where<void>(settings, all_names);
}

std::vector<ConstParamGroup> list_groups(const Settings& settings) {
  return groups_where<const void>(settings, all_names);
}

std::vector<Param> list_params(Settings& settings) {
  return params_of<void>(settings);
}

std::vector<ConstParam> list_params(const Settings& settings) {
  return params_of<const void>(settings);
}

bool all_met(const Settings& settings, const std::vector<Condition>& conditions) {
  return std::all_of(conditions.begin(), conditions.end(), [&](const Condition& condition) {
    const Value value = find_param(settings, condition.key, "condition").value();
    const auto* word = std::get_if<std::string>(&value);
    const std::string text = word != nullptr ? *word : to_text(value);
    const auto& values = condition.values;
    return (std::find(values.begin(), values.end(), text) != values.end()) != condition.is_unequal;
  });
}

bool matters(const Settings& settings, const ConstParamGroup& group) {
  return all_met(settings, parse_conditions(group.description->matters_when));
}

bool matters(const Settings& settings, const ConstParamGroup& group, const Field& field) {
  return all_met(settings, conditions_of(group, field));
}

std::vector<Condition> conditions_of(const ConstParamGroup& group, const Field& field) {
  std::vector<Condition> conditions = parse_conditions(group.description->matters_when);
  for (Condition& condition : parse_conditions(field.matters_when)) {
    if (condition.key.find('.') == std::string::npos) condition.key = group.prefix + "." + condition.key;
    conditions.push_back(std::move(condition));
  }
  return conditions;
}

bool has_param(const Settings& settings, const std::string& key) {
  return lookup<const void>(settings, key).has_value();
}

Param find_param(Settings& settings, const std::string& key, const std::string& where) {
  if (const std::optional<Param> param = lookup<void>(settings, key)) return *param;
  throw_unknown(settings, key, where);
}

ConstParam find_param(const Settings& settings, const std::string& key, const std::string& where) {
  if (const std::optional<ConstParam> param = lookup<const void>(settings, key)) return *param;
  throw_unknown(settings, key, where);
}

std::string group_text(const Description& description, const void* owner) {
  std::string text;
  for (const Field& field : description.fields) {
    text += field.name;
    text += " = " + to_text(field.get(owner)) + "\n";
  }
  return text;
}

void set_param_text(Settings& settings, const std::string& key, const std::string& text,
                    const std::string& where) {
  const Param param = find_param(settings, key, where);
  param.set(value_from_text(param, text, where), where);
}

void apply_assignment(Settings& settings, const std::string& assignment) {
  const size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw input_error("--set " + assignment, "is not KEY=VALUE", "for example --set combine.k_depth=0.005");
  }
  const std::string key(trim(assignment.substr(0, equals)));
  set_param_text(settings, key, assignment.substr(equals + 1), "--set " + assignment);
}

void check_settings(const Settings& settings) {
  check_texts(settings);
  check_camera(settings.camera);
  check_names_differ(settings);
  parse_profile(settings.stroke.profile, "stroke.profile");
  for (const LightParams& light : settings.lights) {
    if (light.type == LightType::directional && light.direction == glm::vec3(0.0F)) {
      throw input_error("light." + light.name + ".direction", "is [0, 0, 0], which is no direction",
                        "give the direction towards the light, such as [0, 1, 0]");
    }
  }
}

std::optional<size_t> main_model_index(const Settings& settings) {
  for (size_t i = 0; i < settings.models.size(); ++i) {
    if (settings.models[i].shape == Shape::mesh) return i;
  }
  return settings.models.empty() ? std::nullopt : std::optional<size_t>(0);
}

MeshParams level_of(const Settings& settings, size_t model) {
  return main_model_index(settings) == model ? settings.mesh : MeshParams{};
}

ModelParams& main_model(Settings& settings) {
  const std::optional<size_t> index = main_model_index(settings);
  if (!index) throw input_error("scene", "has no models", "add a [[model]] table");
  return settings.models[*index];
}

}  // namespace inkbench
