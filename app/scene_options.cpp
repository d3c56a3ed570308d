// SPDX-License-Identifier: MIT
#include "app/scene_options.h"

#include "app/size_option.h"
#include "pipeline/base/files.h"
#include "pipeline/base/log.h"
#include "pipeline/export.h"
#include "pipeline/mesh/levels/replace_mesh.h"
#include "pipeline/mesh/levels/scene_file.h"
#include "pipeline/settings/style_file.h"

namespace inkbench {
namespace {

ChosenScene base_scene(const SceneOptions& options, const std::optional<ImageOrigin>& origin) {
  if (origin) return {origin->settings, origin->buffer};
  return {load_scene_file(options.scene.empty() ? project_file("data/scenes/paper.toml")
                                                : fs::path(options.scene)),
          std::nullopt};
}

}  // namespace

void add_scene_options(CLI::App& command, SceneOptions& options) {
  auto* scene = command.add_option(
      "--scene", options.scene,
      "Scene file (TOML, or glTF, FBX and more: a model for each part); the paper's scene without it");
  command.add_option("--from", options.from, "Make an exported image again, from the parameters it carries")
      ->excludes(scene);
  command.add_option("--mesh", options.mesh,
                     "Mesh file (OBJ, PLY, OFF, STL, glTF, FBX and more) to put where the main model stands");
  command.add_option("--size", options.size, "Image size in px, as WIDTHxHEIGHT");
  command.add_option("--style", options.style,
                     "Draw strokes in a style: a bundled one (`inkbench styles` lists them), or a file");
  command
      .add_option("--set", options.assignments,
                  "KEY=VALUE: set a parameter (`inkbench params` lists them); repeatable")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

ChosenScene chosen_scene(const SceneOptions& options) {
  std::optional<ImageOrigin> origin;
  if (!options.from.empty()) origin = read_origin(options.from);
  ChosenScene chosen = base_scene(options, origin);
  if (!options.mesh.empty()) replace_main_mesh(chosen.settings, options.mesh);
  if (!options.size.empty()) apply_size(chosen.settings, options.size);
  if (!options.style.empty()) apply_style(chosen.settings, options.style, fs::current_path(), "--style");
  for (const std::string& assignment : options.assignments) apply_assignment(chosen.settings, assignment);
  check_settings(chosen.settings);
  if (origin) {
    for (const std::string& note : notes_on_changed_files(options.from, *origin, chosen.settings))
      log_note(note);
  }
  return chosen;
}

}  // namespace inkbench
