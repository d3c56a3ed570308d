// SPDX-License-Identifier: MIT
// Other programs' scenes through Assimp, as the module pipeline/mesh/formats/assimp gives them: it is opened
// when the first such file is read, and nothing else knows of Assimp. Only plain calls, standard types and
// pure data cross over.
#pragma once

#include <string>

#include "pipeline/mesh/formats/imported_scene.h"

namespace inkbench {

struct SceneImporter {
  /// Reads the file and those that it refers to. False where it cannot be read: `problem` is the library's
  /// own text in one line. It is not to be trusted with any file but in `call_isolated`. May throw what is a
  /// std::exception.
  bool (*read)(const std::string& path, ImportedScene& scene, std::string& problem);
};

/// Opens the module at the first call. Errors (work): it is missing or cannot be opened.
const SceneImporter& scene_importer();

}  // namespace inkbench

/// What the module exports.
extern "C" const inkbench::SceneImporter* inkbench_scene_importer();
