// SPDX-License-Identifier: MIT
#include "app/panels/frame/image_question.h"

#include <imgui.h>

#include <algorithm>
#include <optional>

#include "app/panels/widgets/widgets.h"
#include "app/window/gui.h"
#include "app/window/theme.h"

namespace inkbench {
namespace {

std::optional<ImageUse> chosen_use(UiMap& ui_map) {
  struct Choice {
    const char* label;
    const char* item;
    ImageUse use;
  };
  constexpr Choice kChoices[] = {{"Diffuse ramp", "image question:diffuse", ImageUse::diffuse_ramp},
                                 {"Specular ramp", "image question:specular", ImageUse::specular_ramp},
                                 {"Leave it", "image question:leave", ImageUse::nothing}};
  std::optional<ImageUse> chosen;
  for (const Choice& choice : kChoices) {
    if (ImGui::Button(choice.label)) chosen = choice.use;
    ui_map.mark_item(choice.item);
    ImGui::SameLine();
  }
  ImGui::NewLine();
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) chosen = ImageUse::nothing;
  return chosen;
}

}  // namespace

void draw_image_question(FileOpener& files, WindowRequests& requests, UiMap& ui_map) {
  constexpr const char* kId = "image question";
  if (files.asked() != nullptr && !ImGui::IsPopupOpen(kId)) ImGui::OpenPopup(kId);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 3}, ImGuiCond_Appearing, {0.5F, 0.5F});
  ImGui::SetNextWindowSize({std::min(scaled(560), screen.x - scaled(20)), 0});
  const bool open = ImGui::BeginPopupModal(
      kId, nullptr,
      ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoResize);
  if (!open) return;
  if (ImGui::IsWindowAppearing()) requests.wake_in(0.0);  // its height is known by then
  if (files.asked() != nullptr) {
    ImGui::PushFont(fonts().bold);
    ImGui::TextUnformatted(files.asked()->path.filename().string().c_str());
    ImGui::PopFont();
    wrapped_text("This image carries no settings of inkbench. Is its first row a ramp?", theme().faint);
    if (const std::optional<ImageUse> use = chosen_use(ui_map)) files.answer(*use);
  }
  if (files.asked() == nullptr) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace inkbench
