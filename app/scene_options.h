// SPDX-License-Identifier: MIT
// The options by which commands that draw choose what is drawn: `--scene`, `--from`, `--mesh`, `--size`,
// `--style`, `--set`.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/buffers.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

struct SceneOptions {
  std::string scene, from, mesh, size, style;
  std::vector<std::string> assignments;
};

/// `options` must outlive the command.
void add_scene_options(CLI::App& command, SceneOptions& options);

struct ChosenScene {
  Settings settings;
  std::optional<BufferName> buffer;  ///< Of the image that `--from` named.
};

/// A note tells of files behind the image of `--from` that are others now. Errors (input): a file or a value
/// that is wrong, settings that contradict each other.
ChosenScene chosen_scene(const SceneOptions& options);

}  // namespace inkbench
