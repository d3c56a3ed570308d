// SPDX-License-Identifier: MIT
// Dear ImGui's life in a window: its context, fonts at the display's scale, and a frame's begin and end.
#pragma once

#include <imgui.h>

#include "app/window/input.h"
#include "app/window/theme.h"
#include "app/window/window.h"

namespace inkbench {

/// Fonts by their use; DejaVu Sans, or ImGui's own where it is not installed.
struct Fonts {
  ImFont* text = nullptr;
  ImFont* bold = nullptr;
  ImFont* fixed = nullptr;  ///< All characters of one width: paths, logs.
};
const Fonts& fonts();

class Gui {
 public:
  /// The window's context must be current; both must outlive this.
  Gui(Window& window, InputQueue& input);
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;
  ~Gui();

  /// Palette and text size from the next frame on; a `scale` of 0 is the desktop's.
  void set_look(Theme name, float scale);

  void begin_frame();
  /// Draws the frame into the window. Errors (work): what OpenGL reports.
  void end_frame();
  /// Whether a window of the last frame is not seen yet, since ImGui hides it while it measures it: a tooltip
  /// that came up though nothing happened needs another frame.
  bool is_measuring() const;

 private:
  void make_fonts(float scale);

  Window& window_;
  InputQueue& input_;
  Theme theme_ = Theme::dark;
  float scale_ = 0.0F;
  float font_scale_ = 0.0F;
  bool look_changed_ = true;
};

}  // namespace inkbench
