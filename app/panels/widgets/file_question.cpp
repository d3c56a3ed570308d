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
#include "app/window/typing_wish.h"
#include "app/workbench/folder_listing.h"
#include "app/workbench/save_place.h"

namespace inkbench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kId = "file question";

fs::path whole_path(const std::string& typed) {
  std::error_code error;
  return path_from_text(typed, fs::current_path(error));
}

}  // namespace

void FileQuestion::ask(PathQuestion question, std::function<void(const std::string&)> answer) {
  question_ = std::move(question);
  answer_ = std::move(answer);
  problem_.clear();
  replaces_.reset();
  opening_ = true;
  expect_typing();
}

void FileQuestion::accept() {
  const fs::path path = whole_path(path_);
  if (path.empty()) return ImGui::CloseCurrentPopup();
  problem_ = question_.saves ? save_problem(path) : "";
  const bool asks = question_.saves && problem_.empty() && is_taken(path) && replaces_ != path;
  if (asks) replaces_ = path;
  focus_ = asks || !problem_.empty();
  if (focus_) return;
  ImGui::CloseCurrentPopup();
  attempt(problems_, [&] { answer_(path.string()); });
}

void FileQuestion::draw_path() {
  if (std::exchange(focus_, false)) take_keyboard();
  ImGui::SetNextItemWidth(-1);
  entered_ = ImGui::InputText("##path", &path_,
                              ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ui_map_.mark_item("question:path");
  if (!ImGui::IsItemEdited()) return;
  problem_.clear();
  replaces_.reset();
}

void FileQuestion::draw_buttons() {
  const bool accepted = ImGui::Button(replaces_ ? "Replace" : question_.action.c_str()) || entered_;
  ui_map_.mark_item("question:accept");
  ImGui::SameLine();
  const bool cancelled = ImGui::Button("Cancel") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  ImGui::SameLine();
  const float room = ImGui::GetContentRegionAvail().x;
  if (replaces_) {
    fitted_text(replaces_->filename().string() + " is there already. Replace it?", room, theme().warning);
    ui_map_.mark_item("question:replace");
  } else if (!problem_.empty()) {
    fitted_text(problem_, room, theme().error);
    ui_map_.mark_item("question:problem");
  } else {
    ImGui::NewLine();
  }
  if (accepted) return accept();
  if (cancelled) ImGui::CloseCurrentPopup();
}

void FileQuestion::draw() {
  if (std::exchange(opening_, false)) {
    ImGui::OpenPopup(kId);
    focus_ = true;
  }
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
  ImGui::TextUnformatted(question_.title.c_str());
  ImGui::PopFont();
  faint_text(question_.hint);
  draw_path();
  draw_buttons();
  ImGui::EndPopup();
}

}  // namespace inkbench
