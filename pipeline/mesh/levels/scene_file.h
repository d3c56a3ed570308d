// SPDX-License-Identifier: MIT
// Scenes from files: scene files of our own (TOML), and those of other programs (glTF, FBX, ...), each of
// whose parts becomes a model. In: a path. Out: settings.
#pragma once

#include <filesystem>

#include "pipeline/mesh/formats/imported_scene.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

/// Reads either, by the name's ending. Errors (input): as `load_settings` and `import_scene`; a name that
/// ends otherwise.
Settings load_scene_file(const std::filesystem::path& path);

/// A model for each part of `file`, in the file's own units, coloured as its material; the file's first
/// camera and its lights, else a camera that has all in sight and a light over its shoulder; all else as in
/// the paper's scene. Lights are told apart by what reaches the scene's middle: together they are as bright
/// as one. `file` must be absolute. Errors (input): more parts than a scene can list.
Settings imported_settings(const ImportedScene& scene, const std::filesystem::path& file);

}  // namespace inkbench
