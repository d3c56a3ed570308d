#include "app/panels/frame/toolbar.h"

#include <imgui.h>

#include "app/panels/pictures/comparison.h"
#include "app/panels/widgets/widgets.h"

namespace inkbench {
namespace {

void buffers_menu(Workbench& bench) {
  if (ImGui::Button("Buffers")) ImGui::OpenPopup("buffers");
  bench.ui_map.mark_item("buffers");
  if (!ImGui::BeginPopup("buffers")) return;
  for (const BufferName buffer : all_buffers()) {
    bool listed = bench.is_listed(buffer);
    if (ImGui::Checkbox(std::string(name_of(buffer)).c_str(), &listed)) bench.set_listed(buffer, listed);
    bench.ui_map.mark_item("list:" + std::string(name_of(buffer)));
  }
  ImGui::Separator();
  if (ImGui::MenuItem("All")) bench.layout.hidden_buffers.clear();
  ImGui::EndPopup();
}

void picture_combo(Workbench& bench, const char* id, ComparedPicture& which) {
  const bool pinned = bench.pictures.pinned_settings().has_value();
  const auto text = [&](const ComparedPicture& one) {
    return std::string(name_of(one.buffer)) + (one.pinned ? ", pinned" : "");
  };
  const std::string preview = text(which);
  ImGui::SetNextItemWidth(button_width(preview.c_str()) + ImGui::GetFrameHeight());
  const bool open = ImGui::BeginCombo(id, preview.c_str(), ImGuiComboFlags_HeightLargest);
  bench.ui_map.mark_item(id);
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

void comparison_tools(Workbench& bench) {
  Comparison& comparison = bench.view.comparison;
  if (toggle_button("Compare", comparison.active,
                    "Two buffers, or now and the pinned state, in one place (C)."))
    toggle_comparison(bench);
  bench.ui_map.mark_item("compare");
  if (!comparison.active) return;
  ImGui::SameLine();
  picture_combo(bench, "##A", comparison.a);
  ImGui::SameLine();
  picture_combo(bench, "##B", comparison.b);
  ImGui::SameLine();
  if (toggle_button("Flip", comparison.flips, "One at a time; Space flips."))
    comparison.flips = !comparison.flips;
  bench.ui_map.mark_item("flip");
}

void pin_tool(Workbench& bench) {
  const bool pinned = bench.pictures.pinned_settings().has_value();
  if (toggle_button("Pin", pinned,
                    pinned ? "Forget the pinned state." : "Keep this state to compare with (P)."))
    pinned ? bench.pictures.unpin() : pin_state(bench);
  bench.ui_map.mark_item("pin");
  Comparison& comparison = bench.view.comparison;
  if (bench.pictures.pinned_settings()) return;
  comparison.a.pinned = comparison.b.pinned = false;
}

void mouse_tools(Workbench& bench) {
  ViewState& view = bench.view;
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const float width = button_width("Wireframe") + spacing + button_width("Pan") + button_width("Orbit") +
                      button_width("Fit") + button_width("1:1") + 3 * spacing + 2;
  const float place = ImGui::GetWindowContentRegionMax().x - width;
  ImGui::SameLine();
  if (place > ImGui::GetCursorPosX()) {
    ImGui::SetCursorPosX(place);
  } else {
    ImGui::NewLine();  // where there is no room beside the others, below them
  }
  if (toggle_button("Wireframe", view.wireframe, "The triangles of the meshes over the pictures (W)."))
    view.wireframe = !view.wireframe;
  bench.ui_map.mark_item("wireframe");
  ImGui::SameLine();
  if (toggle_button("Pan", view.tool == MouseTool::view, "Dragging moves the pictures; the wheel zooms (V)."))
    view.tool = MouseTool::view;
  bench.ui_map.mark_item("tool:view");
  ImGui::SameLine(0, 2);
  if (toggle_button(
          "Orbit", view.tool == MouseTool::camera,
          "Dragging turns the camera about its target, with Shift along the picture; the wheel moves it "
          "nearer (O, or hold Alt)."))
    view.tool = MouseTool::camera;
  bench.ui_map.mark_item("tool:camera");
  ImGui::SameLine();
  if (ImGui::Button("Fit")) view.fit();
  help_for_item("Fit the pictures into their tiles (F).");
  bench.ui_map.mark_item("fit view");
  ImGui::SameLine();
  if (ImGui::Button("1:1")) view.wanted_magnification = 1.0;
  help_for_item("One picture pixel a window pixel (Z).");
  bench.ui_map.mark_item("one to one");
}

}  // namespace

void draw_toolbar(Workbench& bench) {
  buffers_menu(bench);
  ImGui::SameLine();
  pin_tool(bench);
  ImGui::SameLine();
  comparison_tools(bench);
  mouse_tools(bench);
}

}  // namespace inkbench
