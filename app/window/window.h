// SPDX-License-Identifier: MIT
// A window on the desktop with an OpenGL 4.5 core context, from GLFW, whose header stays behind the .cpp
// files of this folder. In: a title and a size. Out: something to draw into and present.
#pragma once

#include <optional>
#include <string>

#include "pipeline/gl/gl_context.h"

struct GLFWwindow;

namespace inkbench {

struct WindowSize {
  int width_px = 0, height_px = 0;
  bool operator==(const WindowSize&) const = default;
};

class Window {
 public:
  /// Makes the window, not yet visible, and its context current on this thread, with OpenGL's errors
  /// reported as in every context. Errors (work): no display, naming the commands that need none; no OpenGL
  /// 4.5.
  Window(const std::string& title, WindowSize size);
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  ~Window();

  GLFWwindow* handle() const { return handle_; }
  void show();
  void hide();
  bool wants_to_close() const;
  void close();
  /// Of what is drawn into, in the display's pixels.
  WindowSize size() const;
  /// How much larger than usual the desktop wants text to be: 1, 1.5, 2, ...
  float content_scale() const;
  void present();
  bool is_maximised() const;
  void maximise();

  bool is_full_screen() const { return full_screen_; }
  void toggle_full_screen();

 private:
  struct Library {
    Library();
    ~Library();
  } library_;
  GLFWwindow* handle_ = nullptr;
  std::optional<GlContext> resources_;
  bool full_screen_ = false;
  int x_ = 0, y_ = 0;  ///< Place and size before full screen.
  WindowSize windowed_;
};

/// Returns when the desktop has events for us or after so many seconds; infinity waits for events alone.
void wait_for_events(double seconds);

/// Ends `wait_for_events` from any thread.
void wake_window();

/// Hands the events that are there to the callbacks.
void poll_events();

/// Seconds since the program opened its first window.
double seconds_now();

}  // namespace inkbench
