// SPDX-License-Identifier: MIT
// Mouse and keyboard, kept in the order in which they happened and handed to Dear ImGui a frame at a time. On
// a slow renderer several events fall into one frame; ImGui 1.86 looks only at the state they leave, so that
// a click between two movements would land in the wrong place and a short key press would be lost.
#pragma once

#include <bitset>
#include <deque>
#include <string>
#include <vector>

struct GLFWwindow;

namespace inkbench {

struct InputEvent {
  enum class Kind { move, leave, button, scroll, key, text };
  Kind kind = Kind::move;
  double x = 0.0, y = 0.0;  ///< Place of a movement, amount of a scroll.
  int code = 0, scancode = 0, action = 0, mods = 0;
};

class InputQueue {
 public:
  /// Takes over the window's callbacks; must outlive the window's use. One window at a time.
  explicit InputQueue(GLFWwindow* window);
  InputQueue(const InputQueue&) = delete;
  InputQueue& operator=(const InputQueue&) = delete;

  /// Hands the next events to ImGui: as many as leave a state that says what happened. Between
  /// ImGui_ImplGlfw_NewFrame and ImGui::NewFrame.
  void feed();

  bool is_empty() const { return events_.empty(); }

  /// Whether anything happened since the last call, repaint requests of the desktop included.
  bool take_activity();

  /// Files dropped on the window since the last call.
  std::vector<std::string> take_dropped();

 private:
  struct FrameState;
  bool feed_one(const InputEvent& event, FrameState& frame);
  void push(const InputEvent& event);
  static InputQueue& of(GLFWwindow* window);
  void watch_mouse();
  void watch_keyboard();
  void watch_window();

  GLFWwindow* window_;
  std::deque<InputEvent> events_;
  std::vector<std::string> dropped_;
  bool activity_ = true;
  bool holds_keys_ = false;  ///< In this frame, for a text field that is not there yet.
  double mouse_x_ = -1.0, mouse_y_ = -1.0;
  bool mouse_inside_ = false;
  std::bitset<5> buttons_;
};

}  // namespace inkbench
