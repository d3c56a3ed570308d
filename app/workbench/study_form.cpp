// SPDX-License-Identifier: MIT
#include "app/workbench/study_form.h"

#include <algorithm>

#include "app/workbench/whole_paths.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/scratch_folder.h"
#include "pipeline/base/text.h"
#include "pipeline/image/image_file.h"

namespace inkbench {
namespace {

constexpr size_t kMaxSpecBytes = size_t{1} << 20;
constexpr int kMostNames = 1000;

/// "camera.eye.x" -> "eye_x", "combine.k_depth" -> "k_depth".
std::string short_name(const std::string& key) {
  const std::vector<std::string> parts = split(key, '.');
  const bool is_component = parts.size() > 2 && parts.back().size() == 1;
  return is_component ? parts[parts.size() - 2] + "_" + parts.back() : parts.back();
}

std::vector<std::string> short_names(const StudyForm& form) {
  std::vector<std::string> names;
  for (const SweepAxis& axis : form.request.axes) names.push_back(short_name(axis.key));
  return names;
}

std::string title_of(const StudyForm& form) {
  if (!form.request.title.empty()) return form.request.title;
  const std::vector<std::string> names = short_names(form);
  return names.size() == 1 ? "Sweep of " + names[0] : join(names, " by ");
}

bool holds(const fs::path& file, const std::string& text) {
  std::error_code error;
  if (fs::file_size(file, error) != text.size() || error) return false;
  try {
    return read_file(file) == text;
  } catch (const Error&) {
    return false;
  }
}

bool is_there(const fs::path& file) {
  std::error_code error;
  return fs::exists(file, error);
}

/// A spec whose scene is not saved yet is checked in a scratch folder.
StudySpec spec_of(const StudyDraft& draft) {
  if (draft.scene_text.empty()) return parse_spec(draft.text, draft.path, {});
  const ScratchFolder scratch;
  StudyDraft copy = draft;
  copy.path = scratch.path() / draft.path.filename();
  copy.scene_path = scratch.path() / draft.scene_path.filename();
  save_study(copy);
  return load_spec(copy.path);
}

StudyDraft draft_named(const StudyForm& form, const Settings& settings, const fs::path& scene,
                       const std::string& name) {
  const fs::path path = form.folder / (name + ".toml");
  if (form.own_text) {
    StudyDraft draft;
    draft.path = path;
    const bool moves = !form.source.empty() && form.source.parent_path() != form.folder.lexically_normal();
    draft.text = moves ? with_whole_paths(*form.own_text, form.source.parent_path()) : *form.own_text;
    return draft;
  }
  SweepRequest request = form.request;
  request.title = title_of(form);
  Settings sized = settings;
  sized.image.width = form.width_px;
  sized.image.height = form.height_px;
  return draft_study(request, sized, scene, path);
}

/// Under a made name, the first of NAME, NAME_2, ... that is free or holds this very study.
StudyDraft make_draft(const StudyForm& form, const Settings& settings, const fs::path& scene) {
  if (form.own_text && !form.source.empty() && holds(form.source, *form.own_text)) {
    StudyDraft draft;
    draft.path = form.source;
    draft.text = *form.own_text;
    return draft;
  }
  if (!form.name.empty()) return draft_named(form, settings, scene, form.name);
  std::string stem = form.source.empty() ? join(short_names(form), "_") : form.source.stem().string();
  if (stem.empty()) stem = "study";
  StudyDraft draft = draft_named(form, settings, scene, stem);
  for (int i = 2; i < kMostNames && is_there(draft.path) && !holds(draft.path, draft.text); ++i)
    draft = draft_named(form, settings, scene, stem + "_" + std::to_string(i));
  return draft;
}

/// Grids carry their study's spec.
std::string spec_text(const fs::path& file) {
  const std::string text = read_file(file, kMostTextBytes);
  return text.starts_with("\x89PNG") ? read_image_text(file, "inkbench:spec") : text;
}

void check_place(const StudyForm& form) {
  if (!form.folder.is_absolute()) throw input_error("the folder", "is not a whole path", "begin it with /");
  const bool good = form.name.find('/') == std::string::npos && form.name != "." && form.name != "..";
  if (!good) throw input_error("the name", "\"" + form.name + "\" is not a file's name");
  std::error_code error;
  if (form.folder != form.usual_folder && !fs::is_directory(form.folder, error))
    throw input_error("the folder", form.folder.string() + " is not there", "make it, or mend the path");
}

/// Whether the spec's out folder would be the folder itself or something that is no folder.
std::string note_of(const CheckedForm& checked) {
  if (!checked.is_saved && is_there(checked.draft.path))
    return checked.draft.path.filename().string() + " is there already and will be replaced.";
  if (is_there(checked.out / "manifest.json"))
    return "The folder holds a study: cells that are the same are kept.";
  return "";
}

}  // namespace

bool StudyForm::operator==(const StudyForm& other) const {
  const auto same_axis = [](const SweepAxis& a, const SweepAxis& b) {
    return a.key == b.key && a.from == b.from && a.to == b.to && a.count == b.count && a.scale == b.scale &&
           a.values == b.values;
  };
  return std::equal(request.axes.begin(), request.axes.end(), other.request.axes.begin(),
                    other.request.axes.end(), same_axis) &&
         request.title == other.request.title && request.show == other.request.show &&
         request.measures == other.request.measures && width_px == other.width_px &&
         height_px == other.height_px && name == other.name && folder == other.folder &&
         own_text == other.own_text && source == other.source;
}

StudyForm empty_form(const Settings& settings, const fs::path& folder) {
  StudyForm form;
  form.request.title.clear();
  form.width_px = settings.image.width;
  form.height_px = settings.image.height;
  form.folder = form.usual_folder = folder;
  return form;
}

StudyForm form_of_file(const fs::path& file, const fs::path& folder) {
  StudyForm form;
  form.source = fs::absolute(file).lexically_normal();
  form.own_text = spec_text(form.source);
  if (form.own_text->empty() || form.own_text->size() > kMaxSpecBytes || !is_utf8(*form.own_text))
    throw input_error(file.string(), "is no study", "give a spec file (TOML)");
  form.folder = form.usual_folder = folder;
  return form;
}

CheckedForm check_form(const StudyForm& form, const Settings& settings, const fs::path& scene) {
  CheckedForm checked;
  try {
    check_place(form);
    checked.draft = make_draft(form, settings, scene);
    checked.out = form.folder / (form.name.empty() ? checked.draft.path.stem().string() : form.name);
    checked.is_saved = holds(checked.draft.path, checked.draft.text);
    checked.note = note_of(checked);
    checked.spec = spec_of(checked.draft);
  } catch (const std::exception& error) {
    checked.problem = error.what();
    const std::string place = checked.draft.path.string() + ":";
    if (checked.problem.starts_with(place)) checked.problem = "line " + checked.problem.substr(place.size());
  }
  return checked;
}

void save_form(const CheckedForm& form) {
  if (!form.is_saved || !form.draft.scene_text.empty()) save_study(form.draft);
}

std::vector<std::string> sweepable_keys(const Settings& settings) {
  std::vector<std::string> keys;
  for (const ConstParam& param : list_params(settings)) {
    const FieldType type = param.field->type;
    const char* components = type == FieldType::vector ? "xyz" : type == FieldType::colour ? "rgb" : "";
    for (const char* c = components; *c != '\0'; ++c) keys.push_back(param.key + "." + *c);
    if (can_sweep(param)) keys.push_back(param.key);
  }
  return keys;
}

}  // namespace inkbench
