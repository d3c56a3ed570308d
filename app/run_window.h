// SPDX-License-Identifier: MIT
// The window from opening to closing: draws a frame when something happened, and sleeps otherwise.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/window/window.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

struct WindowOptions {
  std::optional<Settings> settings;  ///< To start with; without them the last session comes back.
  std::filesystem::path scene;       ///< The file that they came from.
  std::string file;                  ///< To open at the start; may be empty.
  std::optional<WindowSize> size;    ///< Else as it was last.
  std::string state_file;            ///< Where to write what tests read; may be empty.
  std::string drag_key;              ///< A parameter to drag by itself, to measure frames; may be empty.
  int drag_frames = 0;
};

/// Errors (work): no display, no OpenGL 4.5; all later ones are shown in the window.
void run_window(const WindowOptions& options);

}  // namespace inkbench
