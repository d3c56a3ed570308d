// SPDX-License-Identifier: MIT
#include "app/panels/frame/main_frame.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/panels/frame/edit_menu.h"
#include "app/panels/frame/image_question.h"
#include "app/panels/frame/keys_page.h"
#include "app/panels/frame/notices.h"
#include "app/panels/frame/status_bar.h"
#include "app/panels/frame/timings.h"
#include "app/panels/frame/toolbar.h"
#include "app/panels/pictures/mark_brush.h"
#include "app/panels/widgets/attempt.h"
#include "app/panels/widgets/held_drag.h"
#include "app/panels/widgets/hover.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/theme.h"
#include "app/workbench/open_outside.h"
#include "pipeline/base/files.h"

namespace inkbench {
namespace {

constexpr float kSmallestLeft = 264, kSmallestRight = 220, kSmallestBottom = 70, kSmallestMiddle = 240;
constexpr float kDivider = 4;
/// Windows that are narrower or lower fold panels away, so that the pictures keep at least half of them.
constexpr float kRightFits = 860, kLeftFits = 560, kBottomFits = 420;

struct Area {
  ImVec2 low, high;
  bool is_empty() const { return high.x - low.x < 1 || high.y - low.y < 1; }
};

constexpr ImGuiWindowFlags kPanelFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                         ImGuiWindowFlags_NoSavedSettings |
                                         ImGuiWindowFlags_NoBringToFrontOnFocus;

template <class Draw>
void panel(const char* name, const Area& area, ImU32 colour, const Draw& draw, ImGuiWindowFlags flags = 0) {
  if (area.is_empty()) return;
  ImGui::SetNextWindowPos(area.low);
  ImGui::SetNextWindowSize({area.high.x - area.low.x, area.high.y - area.low.y});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, colour);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  ImGui::Begin(name, nullptr, kPanelFlags | flags);
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  draw();
  ImGui::End();
}

/// Shares of the window; limited so that a panel can neither vanish nor cover the others.
void move_share(float& share, float by, float whole, float largest) {
  if (by != 0) share = std::clamp(share + by / std::max(whole, 1.0F), 0.08F, largest);
}

/// A strip that is dragged to change the share of the window that one of its sides has. `grows`: 1 where that
/// side is the left or upper one, else -1.
void divider(UiMap& ui_map, const char* name, const Area& area, bool upright, float& share, float grows,
             float largest) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  panel(name, area, theme().line, [&] {
    ImGui::InvisibleButton("grip", {area.high.x - area.low.x, area.high.y - area.low.y});
    ui_map.mark_item(name);
    const bool hot = ImGui::IsItemHovered() || ImGui::IsItemActive();
    if (hot) ImGui::SetMouseCursor(upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    if (hot) ImGui::GetWindowDrawList()->AddRectFilled(area.low, area.high, theme().accent);
    if (const auto before = given_back(share)) share = *before;
    if (!ImGui::IsItemActive()) return;
    const ImGuiIO& io = ImGui::GetIO();
    move_share(share, grows * (upright ? io.MouseDelta.x : io.MouseDelta.y),
               upright ? io.DisplaySize.x : io.DisplaySize.y, largest);
  });
  ImGui::PopStyleVar();
}

void draw_help_menu(WindowLayout& layout, Problems& problems, UiMap& ui_map) {
  const bool open = ImGui::BeginMenu("Help");
  ui_map.mark_item("menu:Help");
  if (!open) return;
  if (menu_item(ui_map, "Keys and mouse", "F1")) layout.show_welcome = true;
  if (menu_item(ui_map, "Documentation"))
    attempt(problems, [] { open_outside(project_file("docs/workbench.md")); });
  ImGui::EndMenu();
}

}  // namespace

MainFrame::MainFrame(Workbench& bench)
    : bench_(bench),
      parameters_(bench.document, bench.layout, bench.view, bench.studies, bench.fit, bench.problems,
                  bench.ui_map),
      presets_(bench.document, bench.files, bench.keeping, bench.problems, bench.ui_map),
      history_(bench.document, bench.ui_map),
      views_(bench.document, bench.viewer.pictures, bench.keeping, bench.problems, bench.ui_map),
      left_(bench.layout, bench.ui_map, parameters_, presets_, history_, views_),
      inspector_(bench.document, bench.viewer, bench.layout, bench.view, bench.ui_map),
      fit_(bench.document, bench.fit, bench.keeping, bench.problems, bench.ui_map),
      judge_(bench.document, bench.viewer, fit_, bench.layout, bench.requests, bench.ui_map),
      side_panel_(bench.layout, bench.ui_map, inspector_, judge_),
      sheet_(bench.document, bench.viewer, bench.layout, bench.view, bench.problems, bench.wanted_dialog,
             bench.ui_map),
      studies_(bench.document, bench.viewer, bench.studies, bench.problems, bench.requests, bench.ui_map),
      ramp_editor_(bench.document, bench.viewer.disk, bench.layout, bench.problems, bench.ui_map),
      style_editor_(bench.document, bench.problems, bench.ui_map),
      log_(bench.log, bench.ui_map),
      file_menu_(bench.document, bench.files, bench.keeping, bench.problems, bench.requests,
                 bench.wanted_dialog, bench.ui_map),
      view_menu_(bench.document, bench.viewer, bench.layout, bench.view, bench.problems, bench.requests,
                 bench.ui_map),
      studies_menu_(bench.document, bench.studies, bench.problems, bench.ui_map),
      dialogs_(bench.document, bench.viewer.pictures, bench.view, bench.files, bench.keeping, bench.problems,
               bench.wanted_dialog, bench.ui_map),
      keep_shortcuts_(bench.document, bench.viewer.pictures, bench.view, bench.files, bench.keeping,
                      bench.problems, bench.wanted_dialog),
      shortcuts_(keep_shortcuts_, bench.document, bench.viewer, bench.layout, bench.view, bench.studies,
                 bench.problems, bench.requests, bench.ui_map) {}

struct MainFrame::Places {
  Area left, middle, right, timings, log, status;
  Area left_divider, right_divider, bottom_divider;
};

MainFrame::Places MainFrame::arrange() const {
  const WindowLayout& layout = bench_.layout;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float top = menu_height_;
  const float foot = screen.y - ImGui::GetTextLineHeight() - scaled(8);
  const float gap = scaled(kDivider);
  const auto side = [&](bool shown, float share, float smallest) {
    return shown ? std::round(std::max(share * screen.x, scaled(smallest))) : 0;
  };
  const bool left_fits = screen.x >= scaled(kLeftFits), right_fits = screen.x >= scaled(kRightFits);
  float left = side(layout.show_parameters && left_fits, layout.left, kSmallestLeft);
  float right =
      side(layout.show_inspector && !bench_.studies.page_open && right_fits, layout.right, kSmallestRight);
  if (!right_fits) left = std::min(left, std::floor(screen.x / 2 - gap));
  const float spare = screen.x - left - right - scaled(kSmallestMiddle);
  if (spare < 0) right = std::max(0.0F, right + spare);
  const bool fits = screen.y >= scaled(kBottomFits);
  const bool has_bottom =
      (fits && (layout.show_timings || layout.show_log)) || bench_.view.editor != OpenEditor::none;
  const float wanted = std::max(std::round(layout.bottom * screen.y), scaled(kSmallestBottom));
  const float bottom = has_bottom ? std::min(wanted, (foot - top) * (fits ? 0.6F : 0.5F)) : 0;
  const float middle_foot = bottom > 0 ? foot - bottom - gap : foot;
  Places places;
  const float x1 = left > 0 ? left + gap : 0;
  const float x2 = right > 0 ? screen.x - right - gap : screen.x;
  places.left = {{0, top}, {left, foot}};
  if (left > 0) places.left_divider = {{left, top}, {left + gap, foot}};
  places.middle = {{x1, top}, {x2, middle_foot}};
  if (right > 0) places.right_divider = {{x2, top}, {x2 + gap, middle_foot}};
  if (right > 0) places.right = {{x2 + gap, top}, {screen.x, middle_foot}};
  if (bottom > 0) {
    float split = std::round(x1 + (screen.x - x1) * 0.56F);
    if (!layout.show_log) split = screen.x;
    if (!layout.show_timings) split = x1 - 1;
    places.bottom_divider = {{x1, middle_foot}, {screen.x, middle_foot + gap}};
    places.timings = {{x1, middle_foot + gap}, {split, foot}};
    places.log = {{split + 1, middle_foot + gap}, {screen.x, foot}};
  }
  places.status = {{0, foot}, screen};
  return places;
}

ShownParts MainFrame::shown_parts() const {
  const bool is_covered = bench_.layout.show_welcome;
  const bool page = bench_.studies.page_open;
  const float width = ImGui::GetIO().DisplaySize.x;
  return {.pictures = !page && !is_covered,
          .left = width >= scaled(kLeftFits),
          .right = !page && width >= scaled(kRightFits)};
}

void MainFrame::draw_dividers(const Places& places) {
  WindowLayout& layout = bench_.layout;
  UiMap& ui_map = bench_.ui_map;
  divider(ui_map, "divider:left", places.left_divider, true, layout.left, 1, 0.42F);
  divider(ui_map, "divider:right", places.right_divider, true, layout.right, -1, 0.42F);
  divider(ui_map, "divider:bottom", places.bottom_divider, false, layout.bottom, -1, 0.6F);
}

template <class Draw>
void MainFrame::draw_editor(const Places& places, const char* heading, const char* close, const Draw& draw) {
  panel(heading, {places.timings.low, places.log.high}, theme().panel, [&] {
    panel_heading(heading);
    if (close_button("close")) bench_.view.editor = OpenEditor::none;
    bench_.ui_map.mark_item(close);
    draw();
  });
}

void MainFrame::draw_bottom(const Places& places) {
  if (bench_.view.editor == OpenEditor::ramps)
    return draw_editor(places, "Ramps", "close ramps", [&] { ramp_editor_.draw(); });
  if (bench_.view.editor == OpenEditor::style)
    return draw_editor(places, "Stroke style", "close style", [&] { style_editor_.draw(); });
  const Viewer& viewer = bench_.viewer;
  panel("timings", places.timings, theme().panel, [&] {
    panel_heading("Timings");
    draw_timings(viewer.pictures.pipeline(), viewer.timer, viewer.window_timer);
  });
  panel("log", places.log, theme().panel, [&] {
    panel_heading("Log");
    log_.draw();
  });
}

void MainFrame::draw_menu_bar() {
  if (ImGui::BeginMainMenuBar()) {
    menu_height_ = ImGui::GetWindowHeight();
    file_menu_.draw();
    draw_edit_menu(bench_.document, bench_.viewer.pictures, bench_.view, bench_.files, bench_.problems,
                   bench_.ui_map);
    view_menu_.draw();
    studies_menu_.draw_menu();
    draw_help_menu(bench_.layout, bench_.problems, bench_.ui_map);
    ImGui::EndMainMenuBar();
  }
  studies_menu_.draw_question();
}

void MainFrame::draw_pictures() {
  draw_toolbar(bench_.viewer, bench_.layout, bench_.view, bench_.ui_map);
  draw_brush_tools(bench_.document, bench_.view, bench_.ui_map);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  sheet_.draw();
  draw_notices(bench_.document, bench_.viewer, bench_.layout, bench_.keeping, bench_.problems, bench_.ui_map,
               low);
}

void MainFrame::draw() {
  const ShortcutRequests keys = shortcuts_.handle(shown_parts());
  if (keys.search) left_.focus_search();
  draw_menu_bar();
  const Places places = arrange();
  panel("left", places.left, theme().panel, [&] { left_.draw(); });
  follow_fit(bench_.fit, bench_.document, bench_.problems, bench_.requests);
  follow_studies(bench_.studies, bench_.problems, bench_.requests);
  if (bench_.studies.page_open) panel("studies", places.middle, theme().panel, [&] { studies_.draw(); });
  panel(
      "pictures", bench_.studies.page_open ? Area{} : places.middle, theme().canvas, [&] { draw_pictures(); },
      ImGuiWindowFlags_NoScrollWithMouse);
  panel("inspector", places.right, theme().panel, [&] { side_panel_.draw(); });
  draw_bottom(places);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(scaled(10), scaled(4)));
  panel("status", places.status, theme().bar,
        [&] { draw_status_bar(bench_.document, bench_.viewer, bench_.view, bench_.studies); });
  ImGui::PopStyleVar();
  draw_dividers(places);
  draw_keys_page(bench_.layout, bench_.ui_map);
  dialogs_.draw();
  draw_image_question(bench_.files, bench_.requests, bench_.ui_map);
  if (is_hover_pending()) bench_.requests.wake_in(kHelpDelay / 2);
}

}  // namespace inkbench
