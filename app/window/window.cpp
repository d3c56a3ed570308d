// SPDX-License-Identifier: MIT
#include "app/window/window.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "pipeline/base/error.h"

namespace inkbench {
namespace {

std::string& last_glfw_error() {
  static std::string text;
  return text;
}

void on_glfw_error(int /*code*/, const char* text) {
  last_glfw_error() = text;
}

void ask_for_context() {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
}

GLFWmonitor* monitor_of(GLFWwindow* window) {
  int x = 0;
  int y = 0;
  glfwGetWindowPos(window, &x, &y);
  int count = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  for (int i = 0; i < count; ++i) {
    int left = 0;
    int top = 0;
    glfwGetMonitorPos(monitors[i], &left, &top);
    const GLFWvidmode* mode = glfwGetVideoMode(monitors[i]);
    const bool inside = x >= left && y >= top && x < left + mode->width && y < top + mode->height;
    if (inside) return monitors[i];
  }
  return glfwGetPrimaryMonitor();
}

}  // namespace

Window::Library::Library() {
  // The same word chooses the renderer as without a window; for GLX it has to be said Mesa's way.
  const char* renderer = std::getenv("INKBENCH_RENDERER");
  if (renderer != nullptr && std::string_view(renderer) == "software")
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 0);
  glfwSetErrorCallback(on_glfw_error);
  if (glfwInit() == GLFW_TRUE) return;
  throw work_error("app", "no display for a window (" + last_glfw_error() + ")",
                   "`inkbench render` and `inkbench study` work without one");
}

Window::Library::~Library() {
  glfwTerminate();
}

Window::Window(const std::string& title, WindowSize size) : windowed_(size) {
  ask_for_context();
  handle_ = glfwCreateWindow(size.width_px, size.height_px, title.c_str(), nullptr, nullptr);
  if (handle_ == nullptr) {
    throw work_error("app", "no window with OpenGL 4.5 could be made (" + last_glfw_error() + ")",
                     "install the GPU's driver or Debian's libgl1-mesa-dri; `inkbench render` and `inkbench "
                     "study` work without a window");
  }
  glfwMakeContextCurrent(handle_);
  glfwSwapInterval(1);
  resources_.emplace();
  glfwSetWindowSizeLimits(handle_, 480, 320, GLFW_DONT_CARE, GLFW_DONT_CARE);
}

Window::~Window() {
  resources_.reset();
  glfwDestroyWindow(handle_);
}

void Window::show() {
  glfwShowWindow(handle_);
  glfwFocusWindow(handle_);
}

void Window::hide() {
  glfwHideWindow(handle_);
}

bool Window::wants_to_close() const {
  return glfwWindowShouldClose(handle_) == GLFW_TRUE;
}

void Window::close() {
  glfwSetWindowShouldClose(handle_, GLFW_TRUE);
}

WindowSize Window::size() const {
  WindowSize size;
  glfwGetFramebufferSize(handle_, &size.width_px, &size.height_px);
  return size;
}

float Window::content_scale() const {
  float x = 1.0F;
  float y = 1.0F;
  glfwGetWindowContentScale(handle_, &x, &y);
  return std::isfinite(x) ? std::clamp(x, 0.5F, 4.0F) : 1.0F;
}

void Window::present() {
  glfwSwapBuffers(handle_);
}

bool Window::is_maximised() const {
  return glfwGetWindowAttrib(handle_, GLFW_MAXIMIZED) == GLFW_TRUE;
}

void Window::maximise() {
  glfwMaximizeWindow(handle_);
}

void Window::toggle_full_screen() {
  if (full_screen_) {
    glfwSetWindowMonitor(handle_, nullptr, x_, y_, windowed_.width_px, windowed_.height_px, GLFW_DONT_CARE);
    full_screen_ = false;
    return;
  }
  GLFWmonitor* monitor = monitor_of(handle_);
  if (monitor == nullptr) return;
  glfwGetWindowPos(handle_, &x_, &y_);
  glfwGetWindowSize(handle_, &windowed_.width_px, &windowed_.height_px);
  const GLFWvidmode* mode = glfwGetVideoMode(monitor);
  glfwSetWindowMonitor(handle_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
  full_screen_ = true;
}

void wait_for_events(double seconds) {
  if (std::isfinite(seconds)) {
    glfwWaitEventsTimeout(std::max(seconds, 1e-3));
  } else {
    glfwWaitEvents();
  }
}

void wake_window() {
  glfwPostEmptyEvent();
}

void poll_events() {
  glfwPollEvents();
}

double seconds_now() {
  return glfwGetTime();
}

}  // namespace inkbench
