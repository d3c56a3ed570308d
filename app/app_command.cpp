// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>

#include "app/commands.h"
#include "app/run_window.h"
#include "app/size_option.h"
#include "pipeline/base/files.h"
#include "pipeline/mesh/levels/scene_file.h"

namespace inkbench {
namespace {

struct AppOptions {
  std::string scene, size, file, state_file, drag;
  int frames = 200;
  std::vector<std::string> assignments;
};

std::optional<WindowSize> window_size(const std::string& text) {
  if (text.empty()) return std::nullopt;
  Settings settings;
  apply_size(settings, text);
  return WindowSize{settings.image.width, settings.image.height};
}

/// What the command line asks for; nothing where it leaves all to the last session.
std::optional<Settings> start_settings(const AppOptions& options, const fs::path& scene) {
  if (options.scene.empty() && options.assignments.empty() && options.file.empty() && options.drag.empty())
    return std::nullopt;
  Settings settings = load_scene_file(scene);
  for (const std::string& assignment : options.assignments) apply_assignment(settings, assignment);
  if (!options.drag.empty()) find_param(settings, options.drag, "--drag");
  check_settings(settings);
  return settings;
}

void open_window(const AppOptions& options) {
  const fs::path scene =
      fs::absolute(options.scene.empty() ? project_file("data/scenes/paper.toml") : fs::path(options.scene));
  WindowOptions window{.settings = start_settings(options, scene),
                       .scene = scene,
                       .file = options.file,
                       .size = window_size(options.size),
                       .state_file = options.state_file,
                       .drag_key = options.drag,
                       .drag_frames = options.drag.empty() ? 0 : options.frames};
  run_window(window);
}

}  // namespace

void add_app_command(CLI::App& app) {
  auto options = std::make_shared<AppOptions>();
  CLI::App* command = app.add_subcommand("app", "Open the window: every buffer side by side, tuned live");
  command->add_option(
      "--scene", options->scene,
      "Scene file (TOML, or glTF, FBX and more); without it the last session, at first the paper's scene");
  command
      ->add_option("--set", options->assignments,
                   "KEY=VALUE: set a parameter (`inkbench params` lists them); repeatable")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_option("--size", options->size,
                      "Size of the window in px, as WIDTHxHEIGHT; else as it was last");
  command->add_option("FILE", options->file, "A scene, an exported image or a mesh to open");
  // For tests and measurements: what the window does, and a slider dragged by itself.
  command->add_option("--state-file", options->state_file)->group("");
  command->add_option("--drag", options->drag)->group("");
  command->add_option("--frames", options->frames)->group("");
  command->footer("Examples:\n  inkbench app\n  inkbench app --set combine.k_normal=0.02 head.ply");
  command->callback([options] { open_window(*options); });
}

}  // namespace inkbench
