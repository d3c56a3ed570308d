// SPDX-License-Identifier: MIT
#include "app/workbench/fit_spec.h"

#include <algorithm>
#include <array>

#include "app/workbench/param_changes.h"
#include "app/workbench/scene_base.h"
#include "pipeline/base/error.h"
#include "pipeline/settings/settings_file.h"
#include "studies/tuning/tune_spec.h"

namespace inkbench {
namespace {

constexpr std::string_view kMethodKey = "edges.method";
/// What a candidate is judged on and by: a search that moved it would change the question.
constexpr std::array<std::string_view, 3> kQuestion{"image", "camera", "judge"};
/// What neither lines nor what they are judged by depend on.
constexpr std::array<std::string_view, 4> kColours{"light", "ramp", "ink", "display"};
/// The threshold stays at first: the k's against it are what counts (docs/pipeline.md).
constexpr std::array<std::string_view, 1> kLeftAlone{"combine.threshold"};

bool is_among(const auto& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string_view head_of(std::string_view key) {
  return key.substr(0, key.find('.'));
}

bool is_searchable(const Field& field) {
  return field.type == FieldType::boolean || field.type == FieldType::integer ||
         field.type == FieldType::real || field.type == FieldType::choice;
}

/// Whether the group is one method's own.
bool is_of_method(const ConstParamGroup& group) {
  const std::vector<Condition> conditions = parse_conditions(group.description->matters_when);
  return std::any_of(conditions.begin(), conditions.end(), [](const Condition& condition) {
    return condition.key == kMethodKey && !condition.is_unequal && condition.values.size() == 1;
  });
}

}  // namespace

const Description& FitOptions::description() {
  static const Description kDescription{
      "fit",
      "Fitting parameters to the reference lines",
      {field<&FitOptions::budget>({.name = "budget",
                                   .help = "Candidates that are drawn and judged, at most.",
                                   .limits = {kLeastBudget, kMostBudget},
                                   .slider = {20, 5000},
                                   .scale = Scale::log})}};
  return kDescription;
}

bool can_fit(const Settings& settings, const std::string& key) {
  if (key == kMethodKey || is_among(kQuestion, head_of(key))) return false;
  for (const ConstParamGroup& group : list_groups(settings)) {
    if (!key.starts_with(group.prefix + ".")) continue;
    for (const Field& field : group.description->fields) {
      if (key == group.prefix + "." + std::string(field.name))
        return is_searchable(field) && matters(settings, group, field);
    }
  }
  return false;
}

std::vector<std::string> usual_fit_keys(const Settings& settings) {
  std::vector<std::string> keys;
  for (const ConstParamGroup& group : list_groups(settings)) {
    if (!is_of_method(group) && group.prefix != head_of(kMethodKey)) continue;
    for (const Field& field : group.description->fields) {
      const std::string key = group.prefix + "." + std::string(field.name);
      if (can_fit(settings, key)) keys.push_back(key);
    }
  }
  return keys;
}

bool is_fitted_at_first(const Settings& settings, const std::string& key) {
  if (is_among(kLeftAlone, key) || head_of(key) == head_of(kMethodKey) || !can_fit(settings, key))
    return false;
  for (const ConstParamGroup& group : list_groups(settings)) {
    if (key.starts_with(group.prefix + ".") && is_of_method(group))
      return find_param(settings, key, key).is_number();
  }
  return false;
}

std::string fit_scene_text(const FitRequest& request) {
  return settings_text(with_absolute_paths(request.settings));
}

std::string fit_spec_text(const FitRequest& request, const std::string& scene_name) {
  if (request.keys.empty()) throw input_error("fit", "no parameter is ticked", "tick those that may move");
  std::string text = "title = \"Fit\"\nscene = " + to_text(Value(scene_name)) +
                     "\nbudget = " + std::to_string(request.budget) + "\n";
  for (size_t i = 0; i < request.cameras.size(); ++i) {
    text += "\n[[view]]\nname = \"view_" + std::to_string(i + 1) + "\"\n";
    text += "[view.set.camera]\n" + group_text(request.cameras[i]);
  }
  for (const std::string& key : request.keys) {
    if (!can_fit(request.settings, key))
      throw input_error("fit", key + " cannot be fitted", "take its tick away");
    text += "\n[[search]]\nkey = " + to_text(Value(key)) + "\n";
  }
  return text;
}

PaintedMarks fit_marks(const Settings& settings, const PaintedMarks& marks, const FitOptions& options) {
  PaintedMarks result;
  for (const CameraMarks& one : marks) {
    const bool fits = one.width_px == settings.image.width && one.height_px == settings.image.height;
    if (fits && options.uses_marks) result.push_back(one);
  }
  return result;
}

std::vector<CameraParams> fit_cameras(const Settings& settings, std::span<const CameraParams> kept,
                                      const PaintedMarks& marks, const FitOptions& options) {
  std::vector<CameraParams> cameras;
  const auto add = [&](const CameraParams& camera) {
    const bool is_new = std::none_of(cameras.begin(), cameras.end(),
                                     [&](const CameraParams& other) { return same_camera(other, camera); });
    if (is_new) cameras.push_back(camera);
  };
  if (marks.empty() || options.uses_reference) {
    for (const CameraParams& camera : kept) {
      if (options.uses_kept_cameras) cameras.push_back(camera);
    }
    if (cameras.empty()) add(settings.camera);
  }
  for (const CameraMarks& one : marks) add(one.camera);
  const bool are_kept = options.uses_kept_cameras && !kept.empty() && marks.empty();
  const bool is_present_alone = cameras.size() == 1 && same_camera(cameras.front(), settings.camera);
  return is_present_alone && !are_kept ? std::vector<CameraParams>() : cameras;
}

std::string write_fit_marks(const std::filesystem::path& folder, const FitRequest& request) {
  std::vector<MarkedView> views;
  for (const CameraParams& camera : request.cameras)
    views.push_back({"view_" + std::to_string(views.size() + 1), camera});
  if (views.empty()) views.push_back({"", request.settings.camera});
  const std::string tables = write_mark_files(folder, request.marks, views, request.settings.image.width,
                                              request.settings.image.height);
  return tables.empty() || request.uses_reference ? tables : tables + "\n[objective]\nreference = false\n";
}

bool is_still_about(const FitRequest& request, const Settings& settings) {
  if (!same_structure(request.settings, settings)) return false;
  const std::vector<ParamChange> changes = changed_params(request.settings, settings);
  return std::all_of(changes.begin(), changes.end(), [&](const ParamChange& change) {
    const bool is_other_camera = head_of(change.key) == "camera" && !request.cameras.empty();
    return is_among(request.keys, change.key) || is_among(kColours, head_of(change.key)) || is_other_camera;
  });
}

}  // namespace inkbench
