// What opening a file does to the settings, by what the file is.
#pragma once

#include <string>

#include "pipeline/scene/settings.h"

namespace inkbench {

struct OpenedFile {
  Settings settings;
  std::string name;       ///< Of the scene, for titles.
  bool is_whole = false;  ///< The file gives all settings, not a part of them.
};

/// A scene (.toml), an exported image (.png, .exr) with the parameters that it carries, or a mesh (.obj,
/// .ply, .off, .stl) in the place of the main model of `current`. Errors (input): another kind of file; what
/// is wrong with it.
OpenedFile open_file(const Settings& current, const std::string& path);

}  // namespace inkbench
