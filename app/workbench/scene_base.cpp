// SPDX-License-Identifier: MIT
#include "app/workbench/scene_base.h"

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/mesh/levels/scene_file.h"

namespace inkbench {
namespace {

std::string absolute_text(const std::string& path) {
  if (path.empty() || is_named_mesh(path)) return path;
  return fs::absolute(path).lexically_normal().string();
}

/// Fills `base` if the scene can be read and has the settings' models and lights.
bool try_base(const Settings& settings, const fs::path& scene, SceneBase& base) {
  if (scene.empty()) return false;
  try {
    const Settings start = load_scene_file(scene);
    if (!same_structure(start, settings)) return false;
    base.scene = fs::absolute(scene).lexically_normal();
    for (const ParamChange& change : changed_params(start, settings))
      base.changes.push_back(narrowed(change));
    return true;
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

Settings with_absolute_paths(const Settings& settings) {
  Settings result = settings;
  for (const Param& param : list_params(result)) {
    if (!param.field->is_path) continue;
    Value value = param.value();
    if (auto* text = std::get_if<std::string>(&value)) *text = absolute_text(*text);
    if (auto* ramp = std::get_if<Ramp>(&value)) ramp->image = absolute_text(ramp->image);
    param.field->set(param.owner, value);
  }
  return result;
}

SceneBase find_base(const Settings& settings, const fs::path& scene) {
  const Settings portable = with_absolute_paths(settings);
  SceneBase base;
  if (!try_base(portable, scene, base)) try_base(portable, default_scene(), base);
  return base;
}

fs::path default_scene() {
  return project_file("data/scenes/paper.toml");
}

}  // namespace inkbench
