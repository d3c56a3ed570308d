// SPDX-License-Identifier: MIT
#include "pipeline/mesh/formats/scene_importer.h"

#include "pipeline/base/module.h"

namespace inkbench {

const SceneImporter& scene_importer() {
  static const SceneImporter* const importer =  // once, whichever thread is first
      reinterpret_cast<decltype(&inkbench_scene_importer)>(
          open_module("inkbench_scene_import.so", "inkbench_scene_importer",
                      {.what_fails = "this kind of file cannot be read", .package = "libassimp5"}))();
  return *importer;
}

}  // namespace inkbench
