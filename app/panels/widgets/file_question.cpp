// SPDX-License-Identifier: MIT
#include "app/panels/widgets/file_question.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "app/panels/widgets/attempt.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/gui.h"
#include "app/window/theme.h"

namespace inkbench {
namespace {

/// Until the text field has the keyboard.
constexpr int kFramesToSettle = 4;

}  // namespace

void FileQuestion::ask(const std::string& title, const std::string& hint, const std::string& action,
                       std::function<void(const std::string&)> answer) {
  title_ = title;
  hint_ = hint;
  action_ = action;
  answer_ = std::move(answer);
  opening_ = true;
}

void FileQuestion::close_with(bool accepted) {
  ImGui::CloseCurrentPopup();
  if (accepted && !path_.empty()) attempt(problems_, [&] { answer_(path_); });
}

void FileQuestion::draw() {
  constexpr const char* kId = "file question";
  const bool appears = std::exchange(opening_, false);
  if (appears) ImGui::OpenPopup(kId);
  if (appears) frames_to_settle_ = kFramesToSettle;
  if (frames_to_settle_ > 0) requests_.wake_in(0.0);
  frames_to_settle_ = std::max(frames_to_settle_ - 1, 0);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 3}, ImGuiCond_Appearing, {0.5F, 0.5F});
  ImGui::SetNextWindowSize({std::min(scaled(560), screen.x - scaled(20)), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(scaled(18), scaled(14)));
  const bool open = ImGui::BeginPopupModal(
      kId, nullptr,
      ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoResize);
  ImGui::PopStyleVar();
  if (!open) return;
  ImGui::PushFont(fonts().bold);
  ImGui::TextUnformatted(title_.c_str());
  ImGui::PopFont();
  faint_text(hint_);
  if (appears) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  const bool entered = ImGui::InputText(
      "##path", &path_, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ui_map_.mark_item("question:path");
  const bool accepted = ImGui::Button(action_.c_str()) || entered;
  ui_map_.mark_item("question:accept");
  ImGui::SameLine();
  const bool cancelled = ImGui::Button("Cancel") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  if (accepted || cancelled) close_with(accepted);
  ImGui::EndPopup();
}

}  // namespace inkbench
