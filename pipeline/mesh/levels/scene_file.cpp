// SPDX-License-Identifier: MIT
#include "pipeline/mesh/levels/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/log.h"
#include "pipeline/mesh/formats/scene_import.h"
#include "pipeline/mesh/levels/imported_view.h"
#include "pipeline/settings/settings_file.h"

namespace inkbench {
namespace {

constexpr size_t kMostNameCharacters = 40;

/// Letters, digits, "_" and "-" alone, as keys need them, and unlike all others.
std::string key_name(const std::string& name, const std::string& otherwise, std::set<std::string>& taken) {
  std::string plain;
  for (const char c : name.substr(0, kMostNameCharacters)) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
    if (is_plain || (!plain.empty() && plain.back() != '_')) plain.push_back(is_plain ? c : '_');
  }
  while (!plain.empty() && plain.back() == '_') plain.pop_back();
  if (plain.empty()) plain = otherwise;
  std::string apart = plain;
  for (int number = 2; !taken.insert(apart).second; ++number) apart = plain + "_" + std::to_string(number);
  return apart;
}

std::vector<ModelParams> models_of(const ImportedScene& scene, const fs::path& file) {
  std::vector<ModelParams> models;
  std::set<std::string> names;
  for (const ImportedPart& part : scene.parts) {
    ModelParams model;
    model.name = key_name(part.name, "part", names);
    model.mesh = file.string();
    model.part = part.name;
    model.material.colour = part.colour;
    models.push_back(model);
  }
  return models;
}

void tell(const ImportedScene& scene, const fs::path& file) {
  const std::string name = file.filename().string();
  for (const auto* notes : {&scene.notes, &scene.view_notes}) {
    for (const std::string& note : *notes) log_note(name + ": " + note);
  }
  if (scene.cameras.size() > 1) {
    log_note(fmt::format("{}: the first of its {} cameras is taken, '{}'.", name, scene.cameras.size(),
                         scene.cameras.front().name));
  }
}

}  // namespace

Settings imported_settings(const ImportedScene& scene, const fs::path& file) {
  if (scene.parts.size() > kMaxModels) {
    throw input_error(
        file.string(), fmt::format("has {} parts", scene.parts.size()),
        fmt::format("a scene has {} models at most; --mesh draws the file as one model", kMaxModels));
  }
  Settings settings = load_settings(project_file("data/scenes/paper.toml"));
  const SceneBox box = box_of(scene);
  const double aspect = static_cast<double>(settings.image.width) / settings.image.height;
  settings.models = models_of(scene, file);
  settings.camera = imported_camera(scene, box, aspect);
  settings.lights = imported_lights(scene, box, settings.camera);
  std::set<std::string> names;
  for (LightParams& light : settings.lights) light.name = key_name(light.name, "light", names);
  return settings;
}

Settings load_scene_file(const fs::path& path) {
  if (!is_imported(path)) return load_settings(path);
  const std::shared_ptr<const ImportedScene> scene = import_scene(path);
  tell(*scene, path);
  return imported_settings(*scene, fs::absolute(path).lexically_normal());
}

}  // namespace inkbench
