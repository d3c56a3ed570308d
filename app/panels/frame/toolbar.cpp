// SPDX-License-Identifier: MIT
#include "app/panels/frame/toolbar.h"

#include <imgui.h>

#include "app/panels/pictures/comparison.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/listed_buffers.h"
#include "app/window/pictures.h"

namespace inkbench {
namespace {

void buffers_menu(WindowLayout& layout, UiMap& ui_map) {
  if (ImGui::Button("Buffers")) ImGui::OpenPopup("buffers");
  ui_map.mark_item("buffers");
  if (!ImGui::BeginPopup("buffers")) return;
  for (const BufferName buffer : all_buffers()) {
    bool listed = is_listed(layout, buffer);
    if (ImGui::Checkbox(std::string(name_of(buffer)).c_str(), &listed)) set_listed(layout, buffer, listed);
    ui_map.mark_item("list:" + std::string(name_of(buffer)));
  }
  ImGui::Separator();
  if (menu_item(ui_map, "All")) layout.hidden_buffers.clear();
  if (menu_item(ui_map, "As at first")) layout.hidden_buffers = WindowLayout().hidden_buffers;
  ImGui::EndPopup();
}

void picture_combo(Pictures& pictures, UiMap& ui_map, const char* id, ComparedPicture& which) {
  const bool pinned = pictures.pinned_settings().has_value();
  const auto text = [&](const ComparedPicture& one) {
    return std::string(name_of(one.buffer)) + (one.pinned ? ", pinned" : "");
  };
  const std::string preview = text(which);
  ImGui::SetNextItemWidth(button_width(preview.c_str()) + ImGui::GetFrameHeight());
  const bool open = ImGui::BeginCombo(id, preview.c_str(), ImGuiComboFlags_HeightLargest);
  ui_map.mark_item(id);
  if (!open) return;
  for (int side = 0; side < (pinned ? 2 : 1); ++side) {
    if (side > 0) ImGui::Separator();
    for (const BufferName buffer : all_buffers()) {
      const ComparedPicture one{buffer, side > 0};
      if (ImGui::Selectable(text(one).c_str(), one == which)) which = one;
    }
  }
  ImGui::EndCombo();
}

void comparison_tools(Pictures& pictures, ViewState& view, UiMap& ui_map) {
  Comparison& comparison = view.comparison;
  if (toggle_button("Compare", comparison.active,
                    "Two buffers, or now and the pinned state, in one place (C)."))
    toggle_comparison(pictures, view);
  ui_map.mark_item("compare");
  if (!comparison.active) return;
  ImGui::SameLine();
  picture_combo(pictures, ui_map, "##A", comparison.a);
  ImGui::SameLine();
  picture_combo(pictures, ui_map, "##B", comparison.b);
  ImGui::SameLine();
  if (toggle_button("Flip", comparison.flips, "One at a time; Space flips."))
    comparison.flips = !comparison.flips;
  ui_map.mark_item("flip");
}

void pin_tool(Viewer& viewer, ViewState& view, UiMap& ui_map) {
  const bool pinned = viewer.pictures.pinned_settings().has_value();
  if (toggle_button("Pin", pinned,
                    pinned ? "Forget the pinned state." : "Keep this state to compare with (P)."))
    pinned ? viewer.pictures.unpin() : pin_state(viewer, view);
  ui_map.mark_item("pin");
  Comparison& comparison = view.comparison;
  if (viewer.pictures.pinned_settings()) return;
  comparison.a.pinned = comparison.b.pinned = false;
}

void mouse_tools(ViewState& view, UiMap& ui_map) {
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const float width = button_width("Wireframe") + spacing + button_width("Pan") + button_width("Orbit") +
                      button_width("Mark") + button_width("Fit") + button_width("1:1") + 3 * spacing + 4;
  const float place = ImGui::GetWindowContentRegionMax().x - width;
  ImGui::SameLine();
  if (place > ImGui::GetCursorPosX()) {
    ImGui::SetCursorPosX(place);
  } else {
    ImGui::NewLine();  // where there is no room beside the others, below them
  }
  if (toggle_button("Wireframe", view.wireframe, "The triangles of the meshes over the pictures (W)."))
    view.wireframe = !view.wireframe;
  ui_map.mark_item("wireframe");
  ImGui::SameLine();
  if (toggle_button("Pan", view.tool == MouseTool::view, "Dragging moves the pictures; the wheel zooms (V)."))
    view.tool = MouseTool::view;
  ui_map.mark_item("tool:view");
  ImGui::SameLine(0, 2);
  if (toggle_button(
          "Orbit", view.tool == MouseTool::camera,
          "Dragging turns the camera about its target, with Shift along the picture; the wheel moves it "
          "nearer (O, or hold Alt)."))
    view.tool = MouseTool::camera;
  ui_map.mark_item("tool:camera");
  ImGui::SameLine(0, 2);
  if (toggle_button("Mark", view.tool == MouseTool::mark,
                    "Dragging paints where lines are wanted, and which are not (M)."))
    view.tool = MouseTool::mark;
  ui_map.mark_item("tool:mark");
  ImGui::SameLine();
  if (ImGui::Button("Fit")) view.fit();
  help_for_item("Fit the pictures into their tiles (F).");
  ui_map.mark_item("fit view");
  ImGui::SameLine();
  if (ImGui::Button("1:1")) view.wanted_magnification = 1.0;
  help_for_item("One picture pixel a window pixel (Z).");
  ui_map.mark_item("one to one");
}

}  // namespace

void draw_toolbar(Viewer& viewer, WindowLayout& layout, ViewState& view, UiMap& ui_map) {
  buffers_menu(layout, ui_map);
  ImGui::SameLine();
  pin_tool(viewer, view, ui_map);
  ImGui::SameLine();
  comparison_tools(viewer.pictures, view, ui_map);
  mouse_tools(view, ui_map);
}

}  // namespace inkbench
