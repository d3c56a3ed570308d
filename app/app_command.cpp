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

/// A scene and changes of it in place of the last session's.
void take_settings(const AppOptions& options, WindowOptions& window) {
  window.scene =
      fs::absolute(options.scene.empty() ? project_file("data/scenes/paper.toml") : fs::path(options.scene));
  Settings settings = load_settings(window.scene);
  for (const std::string& assignment : options.assignments) apply_assignment(settings, assignment);
  if (!options.drag.empty()) find_param(settings, options.drag, "--drag");
  check_settings(settings);
  window.settings = std::move(settings);
}

void open_window(const AppOptions& options) {
  WindowOptions window{.file = options.file,
                       .size = window_size(options.size),
                       .state_file = options.state_file,
                       .drag_key = options.drag,
                       .drag_frames = options.drag.empty() ? 0 : options.frames};
  const bool session = options.scene.empty() && options.assignments.empty() && options.drag.empty();
  if (!session) take_settings(options, window);
  run_window(window);
}

}  // namespace

void add_app_command(CLI::App& app) {
  auto options = std::make_shared<AppOptions>();
  CLI::App* command = app.add_subcommand("app", "Open the window: every buffer side by side, tuned live");
  command->add_option(
      "--scene", options->scene,
      "Scene file (TOML); without it, --set changes the paper's scene, and else the last session comes back");
  command
      ->add_option("--set", options->assignments,
                   "KEY=VALUE: set a parameter (`inkbench params` lists them); repeatable")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_option("--size", options->size,
                      "Size of the window in px, as WIDTHxHEIGHT; else as it was last");
  command->add_option("FILE", options->file, "To open: a scene, preset, exported image, mesh, ramp or study");
  // For tests and measurements: what the window does, and a slider dragged by itself.
  command->add_option("--state-file", options->state_file)->group("");
  command->add_option("--drag", options->drag)->group("");
  command->add_option("--frames", options->frames)->group("");
  command->footer("Examples:\n  inkbench app\n  inkbench app --set combine.k_normal=0.02 head.ply");
  command->callback([options] { open_window(*options); });
}

}  // namespace inkbench
