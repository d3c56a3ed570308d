#include <filesystem>
#include <memory>

#include "app/commands.h"
#include "app/size_option.h"
#include "app/window/run_window.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/scene/settings_file.h"

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

void open_window(const AppOptions& options) {
  const fs::path scene =
      options.scene.empty() ? project_file("data/scenes/paper.toml") : fs::path(options.scene);
  WindowOptions window{.settings = load_settings(scene),
                       .scene_name = scene.filename().string(),
                       .file = options.file,
                       .size = window_size(options.size),
                       .state_file = options.state_file,
                       .drag_key = options.drag,
                       .drag_frames = options.drag.empty() ? 0 : options.frames};
  for (const std::string& assignment : options.assignments) apply_assignment(window.settings, assignment);
  if (!options.drag.empty()) find_param(window.settings, options.drag, "--drag");
  check_settings(window.settings);
  run_window(window);
}

}  // namespace

void add_app_command(CLI::App& app) {
  auto options = std::make_shared<AppOptions>();
  CLI::App* command = app.add_subcommand("app", "Open the window: every buffer side by side, tuned live");
  command->add_option("--scene", options->scene, "Scene file (TOML); the paper's scene without it");
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
