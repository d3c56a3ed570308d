// SPDX-License-Identifier: MIT
#include "app/panels/frame/view_menu.h"

#include <imgui.h>

#include "app/panels/frame/shortcuts.h"
#include "app/panels/pictures/comparison.h"
#include "app/panels/pictures/views_panel.h"
#include "app/panels/widgets/widgets.h"

namespace inkbench {

void ViewMenu::draw() {
  const bool open = ImGui::BeginMenu("View");
  ui_map_.mark_item("menu:View");
  if (!open) return;
  const auto panel = [&](const char* label, bool& shown) {
    if (menu_item(ui_map_, label, nullptr, shown)) shown = !shown;
  };
  panel("Left panel", layout_.show_parameters);
  panel("Inspector", layout_.show_inspector);
  panel("Timings", layout_.show_timings);
  panel("Log", layout_.show_log);
  const auto editor = [&](const char* label, const char* key, OpenEditor which) {
    if (menu_item(ui_map_, label, key, view_.editor == which)) view_.toggle(which);
  };
  editor("Ramp editor", "R", OpenEditor::ramps);
  editor("Stroke style editor", "T", OpenEditor::style);
  ImGui::Separator();
  if (menu_item(ui_map_, "Pin this state", "P")) pin_state(viewer_, view_);
  if (menu_item(ui_map_, "Compare", "C", view_.comparison.active)) toggle_comparison(viewer_.pictures, view_);
  if (menu_item(ui_map_, "Wireframe", "W", view_.wireframe)) view_.wireframe = !view_.wireframe;
  if (menu_item(ui_map_, "Orthographic", "X", is_orthographic(document_.settings().camera)))
    toggle_projection(document_, viewer_.pictures, problems_);
  if (menu_item(ui_map_, "Fit the scene", "Home"))
    fit_view(document_, viewer_.pictures, problems_, FitTo::scene);
  ImGui::Separator();
  if (menu_item(ui_map_, "Pictures as they are", "L", layout_.overlay == Overlay::none))
    layout_.overlay = Overlay::none;
  if (menu_item(ui_map_, "Reference lines over them", "L", layout_.overlay == Overlay::reference))
    layout_.overlay = Overlay::reference;
  if (menu_item(ui_map_, "Right and wrong lines", "L", layout_.overlay == Overlay::matches))
    layout_.overlay = Overlay::matches;
  if (menu_item(ui_map_, "Causes of wrong lines", "L", layout_.overlay == Overlay::causes))
    layout_.overlay = Overlay::causes;
  ImGui::Separator();
  if (menu_item(ui_map_, "Dark", nullptr, layout_.theme == Theme::dark)) layout_.theme = Theme::dark;
  if (menu_item(ui_map_, "Light", nullptr, layout_.theme == Theme::light)) layout_.theme = Theme::light;
  ImGui::Separator();
  if (menu_item(ui_map_, "Larger text", "Ctrl++")) change_text_size(layout_, 0.1F);
  if (menu_item(ui_map_, "Smaller text", "Ctrl+-")) change_text_size(layout_, -0.1F);
  ImGui::Separator();
  if (menu_item(ui_map_, "Full screen", "F11")) requests_.toggle_full_screen = true;
  if (menu_item(ui_map_, "Save a screenshot", "F12")) requests_.screenshot = true;
  ImGui::EndMenu();
}

}  // namespace inkbench
