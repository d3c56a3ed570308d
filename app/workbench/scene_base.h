// SPDX-License-Identifier: MIT
// Settings as a scene file and what differs from it: the short way to write them down, for studies and
// command lines.
#pragma once

#include <filesystem>
#include <vector>

#include "app/workbench/param_changes.h"

namespace inkbench {

/// The same settings with absolute paths of meshes and ramp images, as they can be read from any folder.
Settings with_absolute_paths(const Settings& settings);

struct SceneBase {
  std::filesystem::path scene;        ///< Absolute; empty where no scene file has these models and lights.
  std::vector<NarrowChange> changes;  ///< From the scene's settings to `with_absolute_paths` of these.
};

/// `scene` is tried first, then the paper's scene. One that is missing or broken is passed over: the settings
/// were loaded from it once, but it may have changed since.
SceneBase find_base(const Settings& settings, const std::filesystem::path& scene);

/// The paper's scene file, which is what a study and `render` take where they name none.
std::filesystem::path default_scene();

}  // namespace inkbench
