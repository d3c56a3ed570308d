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

ShortcutRequests with_control(Workbench& bench) {
  ShortcutRequests requests;
  requests.search = letter_pressed('f');
  if (letter_pressed('q')) bench.requests.close = true;
  if (pressed(GLFW_KEY_EQUAL) || pressed(GLFW_KEY_KP_ADD)) change_text_size(bench, 0.1F);
  if (pressed(GLFW_KEY_MINUS) || pressed(GLFW_KEY_KP_SUBTRACT)) change_text_size(bench, -0.1F);
  return requests;
}

void fill_by_number(Workbench& bench) {
  for (const BufferName buffer : all_buffers()) {
    const int digit = buffer.info().number_key;
    if (digit < 0) continue;
    if (!pressed(GLFW_KEY_0 + digit) && !pressed(GLFW_KEY_KP_0 + digit)) continue;
    const bool again = bench.view.filled == buffer && !bench.view.comparison.active;
    bench.view.comparison.active = false;
    bench.view.selected = buffer;
    bench.view.filled = again ? std::nullopt : std::optional(buffer);
  }
}

/// One step back towards the sheet of all buffers.
void step_back(Workbench& bench) {
  if (bench.layout.show_welcome) {
    bench.layout.show_welcome = false;
  } else if (bench.problems().contains(ProblemKind::input)) {
    bench.dismiss(ProblemKind::input);
  } else if (bench.studies.page_open) {
    bench.studies.page_open = false;
  } else if (bench.view.marked) {
    bench.view.marked.reset();
  } else if (bench.view.comparison.active) {
    bench.view.comparison.active = false;
  } else {
    bench.view.filled.reset();
  }
}

void toggle_panels(WindowLayout& layout) {
  const bool any = layout.show_parameters || layout.show_inspector || layout.show_timings || layout.show_log;
  layout.show_parameters = layout.show_inspector = layout.show_timings = layout.show_log = !any;
}

/// The arrow keys, again and again while they are held; ten pixels with Shift.
void move_mark_by_keys(Workbench& bench) {
  const int step = ImGui::GetIO().KeyShift ? 10 : 1;
  const auto held = [](int key) { return ImGui::IsKeyPressed(key, true) ? 1 : 0; };
  const int dx = held(GLFW_KEY_RIGHT) - held(GLFW_KEY_LEFT);
  const int dy = held(GLFW_KEY_DOWN) - held(GLFW_KEY_UP);
  if (dx != 0 || dy != 0) move_mark(bench, dx * step, dy * step);
}

void plain_letters(Workbench& bench) {
  if (letter_pressed('f')) bench.view.fit();
  if (letter_pressed('z')) bench.view.wanted_magnification = 1.0;
  if (letter_pressed('c')) toggle_comparison(bench);
  if (letter_pressed('p')) pin_state(bench);
  if (letter_pressed('l')) next_overlay(bench);
  if (letter_pressed('j')) {
    const bool on = bench.layout.show_inspector && bench.layout.side_page == SidePage::judge;
    bench.layout.side_page = on ? SidePage::inspector : SidePage::judge;
    bench.layout.show_inspector = true;
  }
  if (letter_pressed('r')) bench.view.edits_ramps = !bench.view.edits_ramps;
  if (letter_pressed('v')) bench.view.tool = MouseTool::view;
  if (letter_pressed('o')) bench.view.tool = MouseTool::camera;
}

}  // namespace

void change_text_size(Workbench& bench, float change) {
  bench.layout.ui_scale = std::clamp(std::round((text_scale() + change) * 10.0F) / 10.0F, 0.5F, 4.0F);
}

ShortcutRequests handle_shortcuts(Workbench& bench) {
  const ImGuiIO& io = ImGui::GetIO();
  if (pressed(GLFW_KEY_PAUSE)) ++bench.marks;
  if (handle_keep_shortcuts(bench)) return {};
  if (pressed(GLFW_KEY_F1)) bench.layout.show_welcome = !bench.layout.show_welcome;
  if (pressed(GLFW_KEY_F3)) bench.studies.page_open = !bench.studies.page_open;
  if (pressed(GLFW_KEY_F11)) bench.requests.toggle_full_screen = true;
  if (pressed(GLFW_KEY_F12)) bench.requests.screenshot = true;
  if (io.KeyCtrl && !io.KeyAlt) return with_control(bench);
  const bool popup = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  if (io.WantTextInput || popup || io.KeyAlt) return {};
  if (pressed(GLFW_KEY_ESCAPE)) step_back(bench);
  if (pressed(GLFW_KEY_TAB)) toggle_panels(bench.layout);
  Comparison& comparison = bench.view.comparison;
  if (pressed(GLFW_KEY_SPACE) && comparison.active) {
    if (comparison.flips) comparison.shows_b = !comparison.shows_b;
    comparison.flips = true;
  }
  fill_by_number(bench);
  move_mark_by_keys(bench);
  plain_letters(bench);
  return {};
}

}  // namespace inkbench
