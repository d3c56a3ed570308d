// SPDX-License-Identifier: MIT
#include "app/panels/frame/history_panel.h"

#include <imgui.h>

#include "app/panels/widgets/widgets.h"
#include "app/window/theme.h"

namespace inkbench {
namespace {

void step_button(Document& document, UiMap& ui_map, const char* label, const std::string& step, float width,
                 bool can) {
  ImGui::BeginDisabled(!can);
  const bool pressed = ImGui::Button(label, {width, 0});
  ui_map.mark_item(std::string("history:") + label);
  ImGui::EndDisabled();
  if (can) help_for_item(step);
  if (!pressed) return;
  label[0] == 'U' ? document.undo() : document.redo();
}

}  // namespace

void HistoryPanel::draw_step(size_t position) {
  const size_t now = document_.history().position();
  const bool undone = position > now;
  const ImVec2 place = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::PushID(static_cast<int>(position));
  if (ImGui::Selectable("##step", position == now)) document_.go_to_step(position);
  ui_map_.mark_item("step:" + std::to_string(position));
  ImGui::PopID();
  const std::string& name = position == 0 ? "the start" : names_[position - 1];
  draw_fitted_text(*ImGui::GetWindowDrawList(), {place.x + scaled(4), place.y}, width - scaled(8),
                   undone ? theme().faint : theme().text, name);
}

void HistoryPanel::draw() {
  const History& history = document_.history();
  const bool changed = seen_revision_ != document_.revision();
  if (changed) names_ = history.step_names();
  seen_revision_ = document_.revision();
  const float width = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
  step_button(document_, ui_map_, "Undo", history.undo_name(), width, history.can_undo());
  ImGui::SameLine();
  step_button(document_, ui_map_, "Redo", history.redo_name(), width, history.can_redo());
  ImGui::BeginChild("steps", {0, 0}, false, ImGuiWindowFlags_NoBackground);
  const float line = ImGui::GetTextLineHeightWithSpacing();
  if (changed) {
    const float middle = line * static_cast<float>(history.position()) - ImGui::GetWindowHeight() / 2;
    ImGui::SetScrollY(std::max(middle, 0.0F));
  }
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(names_.size()) + 1, line);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) draw_step(static_cast<size_t>(i));
  }
  ImGui::EndChild();
}

}  // namespace inkbench
