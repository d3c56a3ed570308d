// SPDX-License-Identifier: MIT
#include "app/window/input.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include <cfloat>
#include <optional>
#include <set>
#include <utility>

#include "app/window/typing_wish.h"

namespace inkbench {
namespace {

using Kind = InputEvent::Kind;

bool is_modifier(int key) {
  return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER;
}

bool makes_text(int key) {
  return key >= GLFW_KEY_SPACE && key <= GLFW_KEY_WORLD_2;
}

}  // namespace

/// What a frame has been told so far.
struct InputQueue::FrameState {
  std::bitset<5> buttons;  ///< That changed.
  std::set<int> keys;      ///< That changed.
  bool scrolled = false, other_keys = false;
  bool shortcut = false;    ///< A key with Ctrl or Alt: what follows may be meant for what it opens.
  std::optional<int> mods;  ///< That were held for the keys and buttons, as the desktop says.

  /// Whether the event's modifiers are those of the events before it.
  bool agrees(const InputEvent& event) const { return !mods || *mods == event.mods; }
};

InputQueue::InputQueue(GLFWwindow* window) : window_(window) {
  glfwSetWindowUserPointer(window, this);
  watch_mouse();
  watch_keyboard();
  watch_window();
}

InputQueue& InputQueue::of(GLFWwindow* window) {
  return *static_cast<InputQueue*>(glfwGetWindowUserPointer(window));
}

void InputQueue::push(const InputEvent& event) {
  activity_ = true;
  // Movements in a row are one: only where they end matters, and a slow frame would fall behind.
  if (event.kind == Kind::move && !events_.empty() && events_.back().kind == Kind::move) events_.pop_back();
  events_.push_back(event);
}

void InputQueue::watch_mouse() {
  glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double x, double y) {
    of(window).push({.kind = Kind::move, .x = x, .y = y});
  });
  glfwSetCursorEnterCallback(window_, [](GLFWwindow* window, int entered) {
    InputEvent event{.kind = entered == GLFW_TRUE ? Kind::move : Kind::leave};
    glfwGetCursorPos(window, &event.x, &event.y);
    of(window).push(event);
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int button, int action, int mods) {
    of(window).push({.kind = Kind::button, .code = button, .action = action, .mods = mods});
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* window, double x, double y) {
    of(window).push({.kind = Kind::scroll, .x = x, .y = y});
  });
}

void InputQueue::watch_keyboard() {
  glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int scancode, int action, int mods) {
    of(window).push({.kind = Kind::key, .code = key, .scancode = scancode, .action = action, .mods = mods});
  });
  glfwSetCharCallback(window_, [](GLFWwindow* window, unsigned int code) {
    of(window).push({.kind = Kind::text, .code = static_cast<int>(code)});
  });
}

void InputQueue::watch_window() {
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* window, int focused) {
    of(window).activity_ = true;
    ImGui_ImplGlfw_WindowFocusCallback(window, focused);
  });
  const auto repaint = [](GLFWwindow* window) { of(window).activity_ = true; };
  glfwSetWindowRefreshCallback(window_, repaint);
  glfwSetWindowCloseCallback(window_, repaint);
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* window, int, int) { of(window).activity_ = true; });
  glfwSetWindowContentScaleCallback(window_,
                                    [](GLFWwindow* window, float, float) { of(window).activity_ = true; });
  glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
    of(window).activity_ = true;
    for (int i = 0; i < count; ++i) of(window).dropped_.emplace_back(paths[i]);
  });
}

bool InputQueue::feed_one(const InputEvent& event, FrameState& frame) {
  if (holds_keys_ && (event.kind == Kind::key || event.kind == Kind::text)) return false;
  switch (event.kind) {
    case Kind::move:
    case Kind::leave:
      if (frame.buttons.any() || frame.scrolled || !frame.keys.empty()) return false;
      mouse_inside_ = event.kind == Kind::move;
      mouse_x_ = event.x;
      mouse_y_ = event.y;
      return true;
    case Kind::button:
      if (event.code < 0 || event.code >= static_cast<int>(buttons_.size())) return true;
      if (frame.buttons[event.code] || frame.scrolled || !frame.agrees(event)) return false;
      frame.buttons[event.code] = true;
      frame.mods = event.mods;
      buttons_[event.code] = event.action == GLFW_PRESS;
      return true;
    case Kind::scroll:
      if (frame.buttons.any()) return false;
      frame.scrolled = true;
      ImGui_ImplGlfw_ScrollCallback(window_, event.x, event.y);
      return true;
    case Kind::key:
      if (frame.buttons.any() || frame.scrolled || frame.keys.contains(event.code)) return false;
      if (is_modifier(event.code) && !frame.keys.empty()) return false;  // it was held for those keys, or not
      if (!is_modifier(event.code)) {
        if (frame.shortcut && event.action == GLFW_PRESS) return false;
        if (!frame.agrees(event)) return false;
        frame.mods = event.mods;
      }
      frame.keys.insert(event.code);
      frame.shortcut |= !is_modifier(event.code) && event.action == GLFW_PRESS &&
                        (event.mods & (GLFW_MOD_CONTROL | GLFW_MOD_ALT)) != 0;
      frame.other_keys |= !makes_text(event.code);
      ImGui_ImplGlfw_KeyCallback(window_, event.code, event.scancode, event.action, event.mods);
      return true;
    case Kind::text:
      if (frame.other_keys) return false;
      ImGui_ImplGlfw_CharCallback(window_, static_cast<unsigned>(event.code));
      return true;
  }
  return true;
}

void InputQueue::feed() {
  FrameState frame;
  holds_keys_ = keys_must_wait();
  while (!events_.empty() && feed_one(events_.front(), frame)) events_.pop_front();
  ImGuiIO& io = ImGui::GetIO();
  const bool known = mouse_inside_ || buttons_.any();
  io.MousePos =
      known ? ImVec2(static_cast<float>(mouse_x_), static_cast<float>(mouse_y_)) : ImVec2(-FLT_MAX, -FLT_MAX);
  for (size_t i = 0; i < buttons_.size(); ++i) io.MouseDown[i] = buttons_[i];
  // The backend asks for the keys' state now, which may be later than the events of this frame. What the
  // events say is needed as well: GLFW drops a press within the same millisecond as the last one of that key.
  const auto held = [&](int bit, int left, int right) {
    return io.KeysDown[left] || io.KeysDown[right] || (frame.mods.value_or(0) & bit) != 0;
  };
  io.KeyCtrl = held(GLFW_MOD_CONTROL, GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
  io.KeyShift = held(GLFW_MOD_SHIFT, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
  io.KeyAlt = held(GLFW_MOD_ALT, GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
  io.KeySuper = held(GLFW_MOD_SUPER, GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER);
}

bool InputQueue::take_activity() {
  return std::exchange(activity_, false);
}

std::vector<std::string> InputQueue::take_dropped() {
  return std::exchange(dropped_, {});
}

}  // namespace inkbench
