// SPDX-License-Identifier: MIT
#include "app/workbench/sweep_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "app/workbench/scene_base.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/text.h"
#include "pipeline/params/toml_value.h"
#include "pipeline/settings/settings_file.h"

namespace inkbench {
namespace {

constexpr int kMaxCount = 1000;

/// The number as people read it: 0.003 and not the float nearest to it, so that ranges come out round.
double decimal_of(const Value& value) {
  return std::strtod(to_text(value).c_str(), nullptr);
}

std::vector<Value> all_values(const Field& field) {
  if (field.type == FieldType::boolean) return {false, true};
  std::vector<Value> values;
  for (const std::string_view name : field.choices) values.emplace_back(std::string(name));
  return values;
}

/// Without the last digits' noise of 0.55 - 0.5.
double rounded(double value) {
  return std::strtod(fmt::format("{:.9g}", value).c_str(), nullptr);
}

Limits range_around(double value, const Field& field) {
  const bool log = field.scale == Scale::log;
  const double reach = (field.slider.high - field.slider.low) / 4;
  Limits range = log ? Limits{value / 4, value * 4} : Limits{value - reach, value + reach};
  range.low = std::max(rounded(range.low), field.limits.low);
  range.high = std::min(rounded(range.high), field.limits.high);
  const bool is_usable = range.low < range.high && (!log || range.low > 0);
  return is_usable ? range : field.slider;
}

void check_range(const SweepAxis& axis, const ConstParam& param) {
  const std::string where = "sweep of " + axis.key;
  if (!param.is_number())
    throw input_error(where, "is a " + std::string(type_name(param.field->type)), "list its values");
  if (axis.count < 1 || axis.count > kMaxCount)
    throw input_error(where, fmt::format("{} steps", axis.count), fmt::format("give 1 to {}", kMaxCount));
  for (const double end : {axis.from, axis.to}) {
    const Value value = static_cast<float>(end);
    check_value(*param.field, axis.key, value, where);
    if (axis.scale == Scale::log && end <= 0)
      throw input_error(where, "a log scale from " + shortest(axis.from) + " to " + shortest(axis.to),
                        "both must be above 0");
  }
  if (axis.count > 1 && axis.from == axis.to)
    throw input_error(where, "from and to are both " + shortest(axis.from), "give two ends that differ");
}

void check_axes(const std::vector<SweepAxis>& axes, const Settings& settings) {
  if (axes.empty() || axes.size() > 3)
    throw input_error("sweep", fmt::format("over {} parameters", axes.size()), "give one to three");
  std::vector<ConstParam> seen;
  for (const SweepAxis& axis : axes) {
    const ConstParam param = find_param(settings, axis.key, "sweep");
    for (const ConstParam& other : seen) {
      if (param.overlaps(other))
        throw input_error("sweep", axis.key + " and " + other.key + " are the same parameter");
    }
    seen.push_back(param);
    if (axis.values.empty()) check_range(axis, param);
    for (const Value& value : axis.values) {
      if (value.index() != param.value().index())
        throw input_error("sweep of " + axis.key, to_text(value) + " is not a value of it",
                          "it must be " + accepted(*param.field, param.component));
      check_value(*param.field, axis.key, value, "sweep of " + axis.key);
    }
  }
}

std::string text_of(const std::string& text) {
  return to_text(Value(text));
}

std::string list_text(const std::vector<std::string>& items) {
  std::vector<std::string> quoted;
  for (const std::string& item : items) quoted.push_back(text_of(item));
  return "[" + join(quoted, ", ") + "]";
}

std::string axis_text(const SweepAxis& axis) {
  std::string text = "\n[[axis]]\nkey = " + text_of(axis.key) + "\n";
  if (axis.values.empty()) {
    return text + fmt::format("from = {}\nto = {}\ncount = {}\nscale = \"{}\"\n", shortest(axis.from),
                              shortest(axis.to), axis.count, axis.scale == Scale::log ? "log" : "linear");
  }
  std::vector<std::string> values;
  for (const Value& value : axis.values) values.push_back(to_text(value));
  return text + "values = [" + join(values, ", ") + "]\n";
}

bool is_below(const fs::path& relative) {
  return !relative.empty() && *relative.begin() != ".." && relative.is_relative();
}

/// The scene as the spec at `spec` names it: relative to the spec or, for the project's own, to the project,
/// so that both can be moved; else absolute. A spec looks beside itself first, so what lies there must not be
/// another scene of that name.
std::string scene_name(const fs::path& scene, const fs::path& spec) {
  const fs::path folder = fs::absolute(spec).lexically_normal().parent_path();
  const fs::path beside = scene.lexically_relative(folder);
  if (is_below(beside)) return beside.string();
  const fs::path inside = scene.lexically_relative(fs::absolute(project_root()).lexically_normal());
  std::error_code error;
  if (is_below(inside) && !fs::exists(folder / inside, error)) return inside.string();
  return scene.string();
}

/// Not what an axis varies in any case.
bool is_wanted(const NarrowChange& change, const std::vector<SweepAxis>& axes) {
  return std::none_of(axes.begin(), axes.end(), [&](const SweepAxis& axis) {
    return change.key == axis.key || change.key.starts_with(axis.key + ".");
  });
}

}  // namespace

bool can_sweep(const ConstParam& param) {
  const FieldType type = param.field->type;
  return param.is_number() || type == FieldType::boolean || type == FieldType::choice;
}

SweepAxis suggested_axis(const Settings& settings, const std::string& key) {
  const ConstParam param = find_param(settings, key, "sweep");
  const Field& field = *param.field;
  if (!can_sweep(param)) {
    const bool has_components = field.type == FieldType::vector || field.type == FieldType::colour;
    throw input_error("sweep of " + key, "is a " + std::string(type_name(field.type)),
                      has_components ? "sweep one component: " + key + ".x" : "sweep a number or a choice");
  }
  SweepAxis axis{.key = key, .scale = field.scale};
  if (!param.is_number()) {
    axis.values = all_values(field);
    return axis;
  }
  const Limits range = range_around(decimal_of(param.value()), field);
  axis.from = range.low;
  axis.to = range.high;
  if (field.type == FieldType::integer) {
    axis.from = std::round(axis.from);
    axis.to = std::round(axis.to);
    axis.count = static_cast<int>(std::min<double>(axis.count, axis.to - axis.from + 1));
  }
  return axis;
}

StudyDraft draft_study(const SweepRequest& request, const Settings& settings, const fs::path& scene,
                       const fs::path& path) {
  check_axes(request.axes, settings);
  SceneBase base = find_base(settings, scene);
  StudyDraft draft;
  draft.path = path;
  if (base.scene.empty()) {
    draft.scene_path = path.parent_path() / (path.stem().string() + "_scene.toml");
    draft.scene_text = settings_text(with_absolute_paths(settings));
    base.scene = fs::absolute(draft.scene_path).lexically_normal();
  }
  std::vector<std::string> show;
  for (const BufferName buffer : request.show) show.emplace_back(name_of(buffer));
  draft.text = "title = " + text_of(request.title) + "\nscene = " + text_of(scene_name(base.scene, path)) +
               "\nshow = " + list_text(show) + "\n";
  if (!request.measures.empty()) draft.text += "measure = " + list_text(request.measures) + "\n";
  std::string set;
  for (const NarrowChange& change : base.changes) {
    if (is_wanted(change, request.axes)) set += change.key + " = " + to_text(change.after) + "\n";
  }
  if (!set.empty()) draft.text += "\n[set]\n" + set;
  for (const SweepAxis& axis : request.axes) draft.text += axis_text(axis);
  return draft;
}

void save_study(const StudyDraft& draft) {
  if (!draft.scene_text.empty()) write_file_atomically(draft.scene_path, draft.scene_text);
  write_file_atomically(draft.path, draft.text);
}

}  // namespace inkbench
