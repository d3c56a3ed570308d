// SPDX-License-Identifier: MIT
#include "app/workbench/file_opener.h"

#include <fmt/format.h>

#include <utility>

#include "app/workbench/presets.h"
#include "pipeline/base/error.h"
#include "pipeline/base/text.h"
#include "pipeline/mesh/levels/model_mesh.h"
#include "pipeline/mesh/levels/replace_mesh.h"

namespace inkbench {
namespace {

std::string opening(const OpenedFile& file) {
  return "open " + file.path.filename().string();
}

}  // namespace

FileOpener::FileOpener(Document& document, Problems& problems, std::filesystem::path presets_folder,
                       FileTakers takers)
    : document_(document),
      problems_(problems),
      presets_folder_(std::move(presets_folder)),
      takers_(std::move(takers)) {}

bool FileOpener::is_kept_preset(const std::filesystem::path& file) const {
  std::error_code error;
  return std::filesystem::equivalent(file.parent_path(), presets_folder_, error);
}

void FileOpener::take_scene(const OpenedFile& file) {
  if (is_kept_preset(file.path)) {
    const std::string name = file.path.stem().string();
    return document_.accept(*file.settings, "preset " + name, PresetStore(presets_folder_).marks(name));
  }
  document_.accept_from(file.path.filename().string(), file.path, *file.settings, opening(file));
}

void FileOpener::take_mesh(const OpenedFile& file) {
  // A mesh that cannot be read is told before anything changes.
  Settings next = document_.settings();
  replace_main_mesh(next, file.path);
  const ModelParams& model = main_model(next);
  const auto mesh = std::make_shared<Mesh>(make_model_mesh(model));
  for (const std::string& note : mesh->notes)
    problems_.tell(Severity::note, "model '" + model.name + "': " + note);
  takers_.mesh(model, mesh);
  document_.accept(next, opening(file));
}

void FileOpener::take_ramp(const OpenedFile& file, Ramp RampParams::*ramp, const char* name) {
  Settings next = document_.settings();
  next.ramp.*ramp = *file.ramp;
  next.ramp.enabled = true;
  document_.accept(next, fmt::format("{} ramp from {}", name, file.path.filename().string()));
}

void FileOpener::take(const OpenedFile& file) {
  switch (file.kind) {
    case FileKind::exported_image:
      document_.accept_from(file.path.filename().string(), {}, *file.settings, opening(file));
      return takers_.buffer(*file.buffer);
    case FileKind::scene:
    case FileKind::preset:
      return take_scene(file);
    case FileKind::mesh:
      return take_mesh(file);
    case FileKind::ramp:
      return take_ramp(file, &RampParams::diffuse, "diffuse");
    case FileKind::ramp_image:
      return asked_.push_back(file);
    case FileKind::study:
      return takers_.study(file);
  }
}

void FileOpener::tell_opened(const OpenedFile& file) {
  takers_.opened(file.path);
  problems_.tell(Severity::note, fmt::format("opened {}, {}", file.path.string(), name_of(file.kind)));
}

void FileOpener::answer(ImageUse use) {
  const OpenedFile file = std::move(asked_.front());
  asked_.erase(asked_.begin());
  if (use == ImageUse::nothing) return;
  if (document_.is_editing()) document_.end_edit();
  if (use == ImageUse::diffuse_ramp) take_ramp(file, &RampParams::diffuse, "diffuse");
  if (use == ImageUse::specular_ramp) take_ramp(file, &RampParams::specular, "specular");
  tell_opened(file);
}

/// Returns why not; empty where it was opened.
std::string FileOpener::open_one(const std::string& path) {
  try {
    const OpenedFile file = open_file(path);
    if (document_.is_editing()) document_.end_edit();
    take(file);
    if (file.kind != FileKind::ramp_image) tell_opened(file);
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

void FileOpener::open_all(const std::vector<std::string>& paths) {
  std::vector<std::string> problems;
  for (const std::string& path : paths) {
    std::string problem = open_one(path);
    if (!problem.empty()) problems.push_back(std::move(problem));
  }
  if (paths.empty()) return;
  if (problems.empty()) return problems_.dismiss(ProblemKind::input);
  problems_.set(ProblemKind::input, join(problems, "\n"));
}

}  // namespace inkbench
