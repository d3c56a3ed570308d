// SPDX-License-Identifier: MIT
#include "app/workbench/param_changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <map>

#include "pipeline/base/text.h"
#include "studies/sweep/labels.h"

namespace inkbench {
namespace {

template <class Item>
bool same_names(const std::vector<Item>& a, const std::vector<Item>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Item& left, const Item& right) { return left.name == right.name; });
}

std::string side_text(const std::optional<Value>& value) {
  return value ? label_text(*value) : "none";
}

/// "camera" of "camera.eye", "model.rabbit" of "model.rabbit.material.colour".
std::string group_of(const std::string& key) {
  const size_t dot = key.find('.');
  const std::string first = key.substr(0, dot);
  if (first != "model" && first != "light") return first;
  return key.substr(0, key.find('.', dot + 1));
}

std::string one_group_name(const std::string& group, const std::vector<ParamChange>& changes) {
  constexpr size_t kNamed = 3;
  if (changes.size() > kNamed) return fmt::format("{} ({} parameters)", group, changes.size());
  std::vector<std::string> names;
  for (const ParamChange& change : changes) names.push_back(change.key.substr(group.size() + 1));
  return group + "." + join(names, ", ");
}

void add_if_changed(const ConstParam& before, const ConstParam& after, std::vector<ParamChange>& changes) {
  Value old_value = before.value();
  Value new_value = after.value();
  if (old_value != new_value)
    changes.push_back({after.key, after.field, std::move(old_value), std::move(new_value)});
}

std::vector<ParamChange> changes_by_key(const std::vector<ConstParam>& before,
                                        const std::vector<ConstParam>& after) {
  std::map<std::string, const ConstParam*> gone;
  for (const ConstParam& param : before) gone.emplace(param.key, &param);
  std::vector<ParamChange> changes;
  for (const ConstParam& param : after) {
    const auto old = gone.find(param.key);
    if (old == gone.end()) {
      changes.push_back({param.key, param.field, std::nullopt, param.value()});
      continue;
    }
    add_if_changed(*old->second, param, changes);
    gone.erase(old);
  }
  for (const ConstParam& param : before) {
    if (gone.contains(param.key)) changes.push_back({param.key, param.field, param.value(), std::nullopt});
  }
  return changes;
}

}  // namespace

bool same_structure(const Settings& a, const Settings& b) {
  return same_names(a.models, b.models) && same_names(a.lights, b.lights);
}

std::vector<ParamChange> changed_params(const Settings& before, const Settings& after) {
  const std::vector<ConstParam> old_params = list_params(before);
  const std::vector<ConstParam> new_params = list_params(after);
  if (!same_structure(before, after)) return changes_by_key(old_params, new_params);
  std::vector<ParamChange> changes;
  for (size_t i = 0; i < new_params.size(); ++i) add_if_changed(old_params[i], new_params[i], changes);
  return changes;
}

bool same_settings(const Settings& a, const Settings& b) {
  return same_structure(a, b) && changed_params(a, b).empty();
}

void apply_changes(Settings& settings, const std::vector<ParamChange>& changes, bool forward) {
  for (const ParamChange& change : changes) {
    const std::optional<Value>& value = forward ? change.after : change.before;
    assert(value.has_value());
    const Param param = find_param(settings, change.key, "changes");
    param.field->set(param.owner, *value);
  }
}

std::string change_text(const ParamChange& change) {
  if (!change.before || !change.after)
    return fmt::format("{} {} -> {}", change.key, side_text(change.before), side_text(change.after));
  const NarrowChange narrow = narrowed(change);
  std::string before = label_text(narrow.before);
  std::string after = label_text(narrow.after);
  const bool is_number = std::holds_alternative<float>(narrow.before);
  if (before == after && is_number) {
    before = to_text(narrow.before);
    after = to_text(narrow.after);
  }
  if (before == after) return narrow.key;
  return fmt::format("{} {} -> {}", narrow.key, before, after);
}

std::string changes_name(const std::vector<ParamChange>& changes) {
  if (changes.empty()) return "no change";
  const bool one_structure = std::all_of(changes.begin(), changes.end(), [](const ParamChange& change) {
    return change.before.has_value() && change.after.has_value();
  });
  if (!one_structure) return "other models or lights";
  if (changes.size() == 1) return change_text(changes.front());
  const std::string group = group_of(changes.front().key);
  const bool one_group = std::all_of(changes.begin(), changes.end(), [&](const ParamChange& change) {
    return group_of(change.key) == group;
  });
  return one_group ? one_group_name(group, changes) : fmt::format("{} parameters", changes.size());
}

NarrowChange narrowed(const ParamChange& change) {
  assert(change.before && change.after);
  const auto* before = std::get_if<glm::vec3>(&*change.before);
  const auto* after = std::get_if<glm::vec3>(&*change.after);
  NarrowChange whole{change.key, *change.before, *change.after};
  if (before == nullptr || after == nullptr) return whole;
  int differing = -1;
  for (int i = 0; i < 3; ++i) {
    if ((*before)[i] == (*after)[i]) continue;
    if (differing >= 0) return whole;
    differing = i;
  }
  if (differing < 0) return whole;
  const bool is_colour = change.field != nullptr && change.field->type == FieldType::colour;
  const std::string component(1, (is_colour ? "rgb" : "xyz")[differing]);
  return {change.key + "." + component, (*before)[differing], (*after)[differing]};
}

}  // namespace inkbench
