// SPDX-License-Identifier: MIT
#include "app/panels/frame/log_panel.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include "app/panels/widgets/widgets.h"
#include "app/window/theme.h"
#include "app/workbench/place_in_text.h"

namespace inkbench {
namespace {

ImU32 colour_of(Severity severity) {
  if (severity == Severity::error) return theme().error;
  if (severity == Severity::warning) return theme().warning;
  return theme().text;
}

std::string line_of(const Message& message) {
  std::string line = message.time + "  " + message.text;
  if (message.repeats > 1) line += "  (" + std::to_string(message.repeats) + " times)";
  return line;
}

/// Where the message names a place in a file: a word to press, which copies it for an editor.
void draw_place(MessageLog& log, UiMap& ui_map, const Message& message) {
  if (message.severity == Severity::note) return;
  const std::string place = place_in_text(message.text);
  if (place.empty()) return;
  ImGui::SetCursorPosX(scaled(74));
  const float width = ImGui::CalcTextSize(place.c_str()).x;
  ImGui::PushStyleColor(ImGuiCol_Text, theme().accent);
  const bool pressed = ImGui::Selectable(place.c_str(), false, 0, {width, 0});
  ImGui::PopStyleColor();
  ui_map.mark_item("place:" + place);
  help_for_item("Copies " + whole_place(place));
  if (!pressed) return;
  ImGui::SetClipboardText(whole_place(place).c_str());
  log.add(Severity::note, "copied " + whole_place(place));
}

void draw_message(MessageLog& log, UiMap& ui_map, const Message& message, int index) {
  ImGui::PushID(index);
  faint_text(message.time);
  ImGui::SameLine(scaled(74));
  ImGui::PushStyleColor(ImGuiCol_Text, colour_of(message.severity));
  ImGui::PushTextWrapPos(0.0F);
  const std::string repeats = message.repeats > 1 ? "  ×" + std::to_string(message.repeats) : "";
  ImGui::TextUnformatted((message.text + repeats).c_str());
  ui_map.mark_item("log:" + message.text);
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  if (ImGui::BeginPopupContextItem("message")) {
    if (ImGui::MenuItem("Copy")) ImGui::SetClipboardText(message.text.c_str());
    ImGui::EndPopup();
  }
  draw_place(log, ui_map, message);
  ImGui::PopID();
}

}  // namespace

void LogPanel::draw() {
  const float buttons = scaled(190);
  ImGui::SetNextItemWidth(std::max(ImGui::GetContentRegionAvail().x - buttons, scaled(60)));
  ImGui::InputTextWithHint("##filter", "Filter the log", &filter_);
  ImGui::SameLine();
  if (toggle_button("Errors", only_errors_)) only_errors_ = !only_errors_;
  ImGui::SameLine();
  const bool copies = ImGui::Button("Copy");
  ImGui::SameLine();
  if (ImGui::Button("Clear")) log_.clear();
  ImGui::BeginChild("lines", {0, 0}, false, ImGuiWindowFlags_NoBackground);
  std::string copied;
  int index = 0;
  for (const Message& message : log_.messages()) {
    const bool shown = (!only_errors_ || message.severity == Severity::error) &&
                       (filter_.empty() || message.text.find(filter_) != std::string::npos);
    if (!shown) continue;
    draw_message(log_, ui_map_, message, index++);
    if (copies) copied += line_of(message) + "\n";
  }
  if (copies) ImGui::SetClipboardText(copied.c_str());
  if (seen_revision_ != log_.revision()) ImGui::SetScrollHereY(1.0F);
  seen_revision_ = log_.revision();
  ImGui::EndChild();
}

}  // namespace inkbench
