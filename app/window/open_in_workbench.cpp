// What opening a file does to the workbench, by what the file holds.
#include <fmt/format.h>

#include "app/window/workbench.h"
#include "pipeline/base/error.h"
#include "pipeline/base/text.h"
#include "pipeline/mesh/formats/mesh_file.h"
#include "pipeline/mesh/levels/replace_mesh.h"
#include "pipeline/settings/settings_file.h"

namespace inkbench {
namespace {

std::string opening(const OpenedFile& file) {
  return "open " + file.path.filename().string();
}

}  // namespace

/// The baseline is what the file says now: what was changed since then is marked as changed.
Workbench::Origin Workbench::origin_in(const std::filesystem::path& scene, const Settings& settings) {
  if (scene.empty()) return {"unnamed", {}, settings};
  Origin origin{scene.filename().string(), scene, settings};
  try {
    origin.baseline = load_settings(scene);
  } catch (const Error&) {
    // It changed or went away since; its settings are here.
  }
  return origin;
}

void Workbench::take_from(const Origin& origin, const Settings& next, const std::string& step) {
  check_settings(next);
  origins_.push_back(origin);
  history_.record_from(origins_.size() - 1, next, step);
  ++revision_;
}

bool Workbench::take_over(const Settings& next, const std::filesystem::path& scene, const std::string& step) {
  try {
    take_from(origin_in(scene, next), next, step);
  } catch (const Error& error) {
    set_problem(ProblemKind::input, error.what());
    return false;
  }
  dismiss(ProblemKind::input);
  return true;
}

void Workbench::take_mesh(const OpenedFile& file) {
  // A mesh that cannot be read is told before anything changes.
  const auto mesh = std::make_shared<Mesh>(load_mesh_file(file.path));
  Settings next = settings();
  replace_main_mesh(next, file.path);
  const ModelParams& model = main_model(next);
  for (const std::string& note : mesh->notes) tell(Severity::note, "model '" + model.name + "': " + note);
  pictures.pipeline().meshes().take_full(model, mesh);
  history_.record(std::move(next), opening(file));
  ++revision_;
}

/// A preset of the list is a layer on the scene; elsewhere the same file is a scene.
bool Workbench::is_kept_preset(const std::filesystem::path& file) const {
  std::error_code error;
  return std::filesystem::equivalent(file.parent_path(), keeping.presets().folder(), error);
}

void Workbench::take(const OpenedFile& file) {
  const std::string name = file.path.filename().string();
  switch (file.kind) {
    case FileKind::exported_image:
      take_from({name, {}, *file.settings}, *file.settings, opening(file));
      view.selected = *file.buffer;
      if (view.filled) view.filled = *file.buffer;
      return;
    case FileKind::scene:
    case FileKind::preset:
      if (is_kept_preset(file.path)) return replace(*file.settings, "preset " + file.path.stem().string());
      return take_from({name, file.path, *file.settings}, *file.settings, opening(file));
    case FileKind::mesh:
      return take_mesh(file);
    case FileKind::ramp:
    case FileKind::ramp_image: {
      Settings next = settings();
      next.ramp.diffuse = *file.ramp;
      next.ramp.enabled = true;
      history_.record(std::move(next), "diffuse ramp from " + name);
      ++revision_;
      return;
    }
    case FileKind::study:
      if (on_study) return on_study(file);
      take_from({name, {}, file.study->base}, file.study->base, "settings of the study " + name);
      tell(Severity::note, fmt::format("these are the settings that '{}' starts from", file.study->title));
      return;
  }
}

/// Returns why not; empty where it was opened.
std::string Workbench::open_one(const std::string& path) {
  try {
    const OpenedFile file = open_file(path);
    if (is_editing()) end_edit();
    take(file);
    keeping.add_recent(file.path);
    tell(Severity::note, fmt::format("opened {}, {}", file.path.string(), name_of(file.kind)));
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

void Workbench::open_all(const std::vector<std::string>& paths) {
  std::vector<std::string> problems;
  for (const std::string& path : paths) {
    std::string problem = open_one(path);
    if (!problem.empty()) problems.push_back(std::move(problem));
  }
  if (paths.empty()) return;
  if (problems.empty()) return dismiss(ProblemKind::input);
  set_problem(ProblemKind::input, join(problems, "\n"));
}

void Workbench::saved_as(const std::filesystem::path& file) {
  origins_.push_back({file.filename().string(), file, settings()});
  history_.record_from(origins_.size() - 1, settings(), "");
  ++revision_;
  keeping.add_recent(file);
}

}  // namespace inkbench
