// SPDX-License-Identifier: MIT
// What a panel wants of the window itself; the loop takes it after the frame.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace inkbench {

/// What asks for a file's path.
enum class FileDialog { open, save_settings, save_image };

struct WindowRequests {
  bool close = false, toggle_full_screen = false, screenshot = false;
  double wake_seconds = std::numeric_limits<double>::infinity();

  /// Another frame is wanted after so many seconds, though nothing happens until then: a delayed tooltip.
  void wake_in(double seconds) { wake_seconds = std::min(wake_seconds, seconds); }
};

/// A dialog that a menu or a key asked for; the dialogs take it when their turn comes.
using WantedDialog = std::optional<FileDialog>;

}  // namespace inkbench
