// SPDX-License-Identifier: MIT
#include "pipeline/used_files.h"

#include <algorithm>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/text.h"
#include "pipeline/mesh/levels/model_mesh.h"
#include "pipeline/passes/gbuffer/gpu_mesh.h"

namespace inkbench {
namespace {

/// Without hashes. Errors (input): as `mesh_path`.
std::vector<UsedFile> named_files(const Settings& settings) {
  std::vector<UsedFile> files;
  for (const ModelParams& model : settings.models) {
    if (model.visible && model.shape == Shape::mesh)
      files.push_back({"model." + model.name + ".mesh", mesh_path(model.mesh).string(), ""});
  }
  const StrokeParams& stroke = settings.stroke;
  if (settings.ink.from != InkFrom::filter && stroke.brush == Brush::image && !stroke.brush_image.empty())
    files.push_back({"stroke.brush_image", stroke.brush_image, ""});
  if (!settings.ramp.enabled) return files;
  const auto add = [&](const char* key, const Ramp& ramp) {
    if (!ramp.image.empty()) files.push_back({key, ramp.image, ""});
  };
  add("ramp.diffuse", settings.ramp.diffuse);
  add("ramp.specular", settings.ramp.specular);
  return files;
}

/// As `MeshStore::content_key`.
std::string hash_of(const std::string& path) {
  return KeyBuilder().add(read_file(path)).key().text();
}

bool names_the_same(const Settings& a, const Settings& b, const std::string& key) {
  return has_param(a, key) && has_param(b, key) &&
         find_param(a, key, key).value() == find_param(b, key, key).value();
}

}  // namespace

std::vector<UsedFile> used_files(const Settings& settings, MeshStore& meshes) {
  std::vector<UsedFile> files = named_files(settings);
  for (UsedFile& file : files) {
    const bool is_mesh = file.key.starts_with("model.");
    file.hash = is_mesh ? meshes.content_key(file.path).text() : hash_of(file.path);
  }
  return files;
}

std::string used_files_text(const std::vector<UsedFile>& files) {
  std::string text;
  for (const UsedFile& file : files) text += file.key + " " + file.hash + "\n";
  return text;
}

std::vector<UsedFile> used_files_from(std::string_view text) {
  std::vector<UsedFile> files;
  for (const std::string& line : split(text, '\n')) {
    const std::vector<std::string> parts = split(line, ' ');
    if (parts.size() == 2 && is_hex(parts[1], 32)) files.push_back({parts[0], "", parts[1]});
  }
  return files;
}

std::vector<UsedFile> changed_files(const std::vector<UsedFile>& before, const Settings& made_from,
                                    const Settings& now) {
  std::vector<UsedFile> changed;
  for (UsedFile& file : named_files(now)) {
    const auto kept =
        std::find_if(before.begin(), before.end(), [&](const UsedFile& one) { return one.key == file.key; });
    if (kept == before.end() || !names_the_same(made_from, now, file.key)) continue;
    try {
      file.hash = hash_of(file.path);
    } catch (const Error&) {
      continue;
    }
    if (file.hash != kept->hash) changed.push_back(std::move(file));
  }
  return changed;
}

}  // namespace inkbench
