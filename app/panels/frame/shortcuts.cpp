// SPDX-License-Identifier: MIT
#include "app/panels/frame/shortcuts.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/panels/frame/keep_shortcuts.h"
#include "app/panels/pictures/comparison.h"
#include "app/panels/pictures/mark.h"
#include "app/panels/pictures/overlay_legend.h"
#include "app/panels/widgets/letter_key.h"
#include "app/window/theme.h"

namespace inkbench {
namespace {

bool pressed(int key) {
  return ImGui::IsKeyPressed(key, false);
}

void fill_by_number(ViewState& view) {
  for (const BufferName buffer : all_buffers()) {
    const int digit = buffer.info().number_key;
    if (digit < 0) continue;
    if (!pressed(GLFW_KEY_0 + digit) && !pressed(GLFW_KEY_KP_0 + digit)) continue;
    const bool again = view.filled == buffer && !view.comparison.active;
    view.comparison.active = false;
    view.selected = buffer;
    view.filled = again ? std::nullopt : std::optional(buffer);
  }
}

void toggle_panels(WindowLayout& layout) {
  const bool any = layout.show_parameters || layout.show_inspector || layout.show_timings || layout.show_log;
  layout.show_parameters = layout.show_inspector = layout.show_timings = layout.show_log = !any;
}

/// The arrow keys, again and again while they are held; ten pixels with Shift.
void move_mark_by_keys(const Document& document, const Pictures& pictures, ViewState& view) {
  const int step = ImGui::GetIO().KeyShift ? 10 : 1;
  const auto held = [](int key) { return ImGui::IsKeyPressed(key, true) ? 1 : 0; };
  const int dx = held(GLFW_KEY_RIGHT) - held(GLFW_KEY_LEFT);
  const int dy = held(GLFW_KEY_DOWN) - held(GLFW_KEY_UP);
  if (dx != 0 || dy != 0) move_mark(document, pictures, view, dx * step, dy * step);
}

}  // namespace

void change_text_size(WindowLayout& layout, float change) {
  layout.ui_scale = std::clamp(std::round((text_scale() + change) * 10.0F) / 10.0F, 0.5F, 4.0F);
}

ShortcutRequests Shortcuts::with_control(const ShownParts& shown) {
  ShortcutRequests requests;
  requests.search = letter_pressed('f') && shown.left && !layout_.show_welcome && !popup_is_open();
  if (letter_pressed('q')) requests_.close = true;
  if (pressed(GLFW_KEY_EQUAL) || pressed(GLFW_KEY_KP_ADD)) change_text_size(layout_, 0.1F);
  if (pressed(GLFW_KEY_MINUS) || pressed(GLFW_KEY_KP_SUBTRACT)) change_text_size(layout_, -0.1F);
  return requests;
}

/// One step back towards the sheet of all buffers.
void Shortcuts::step_back() {
  if (layout_.show_welcome) {
    layout_.show_welcome = false;
  } else if (problems_.all().contains(ProblemKind::input)) {
    problems_.dismiss(ProblemKind::input);
  } else if (studies_.page_open) {
    studies_.page_open = false;
  } else if (view_.marked) {
    view_.marked.reset();
  } else if (view_.comparison.active) {
    view_.comparison.active = false;
  } else {
    view_.filled.reset();
  }
}

void Shortcuts::keys_of_pictures() {
  Comparison& comparison = view_.comparison;
  if (pressed(GLFW_KEY_SPACE) && comparison.active) {
    if (comparison.flips) comparison.shows_b = !comparison.shows_b;
    comparison.flips = true;
  }
  fill_by_number(view_);
  move_mark_by_keys(document_, viewer_.pictures, view_);
  if (letter_pressed('f')) view_.fit();
  if (letter_pressed('z')) view_.wanted_magnification = 1.0;
  if (letter_pressed('c')) toggle_comparison(viewer_.pictures, view_);
  if (letter_pressed('p')) pin_state(viewer_, view_);
  if (letter_pressed('l')) next_overlay(layout_);
  if (letter_pressed('v')) view_.tool = MouseTool::view;
  if (letter_pressed('o')) view_.tool = MouseTool::camera;
  if (letter_pressed('m')) view_.tool = MouseTool::mark;
}

void Shortcuts::keys_of_panels(const ShownParts& shown) {
  if (pressed(GLFW_KEY_TAB)) toggle_panels(layout_);
  if (letter_pressed('r')) view_.toggle(OpenEditor::ramps);
  if (letter_pressed('t')) view_.toggle(OpenEditor::style);
  if (!letter_pressed('j') || !shown.right) return;
  const bool on = layout_.show_inspector && layout_.side_page == SidePage::judge;
  layout_.side_page = on ? SidePage::inspector : SidePage::judge;
  layout_.show_inspector = true;
}

void Shortcuts::function_keys() {
  if (pressed(GLFW_KEY_F11)) requests_.toggle_full_screen = true;
  if (pressed(GLFW_KEY_F12)) requests_.screenshot = true;
  if (popup_is_open()) return;
  if (pressed(GLFW_KEY_F1)) layout_.show_welcome = !layout_.show_welcome;
  if (pressed(GLFW_KEY_F3) && !layout_.show_welcome) studies_.page_open = !studies_.page_open;
}

ShortcutRequests Shortcuts::handle(const ShownParts& shown) {
  const ImGuiIO& io = ImGui::GetIO();
  if (pressed(GLFW_KEY_PAUSE)) ++ui_map_.pauses;
  if (keep_.handle(shown.pictures, layout_.show_welcome)) return {};
  function_keys();
  if (io.KeyCtrl && !io.KeyAlt) return with_control(shown);
  const bool has_escape = !io.WantTextInput && !popup_is_open() && !io.KeyAlt;
  if (has_escape && pressed(GLFW_KEY_ESCAPE)) step_back();
  if (!keys_are_free(layout_)) return {};
  if (shown.pictures) keys_of_pictures();
  keys_of_panels(shown);
  return {};
}

}  // namespace inkbench
