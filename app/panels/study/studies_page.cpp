// SPDX-License-Identifier: MIT
#include "app/panels/study/studies_page.h"

#include <imgui.h>

#include "app/panels/study/study_list.h"
#include "app/panels/widgets/attempt.h"
#include "app/panels/widgets/banner.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/gui.h"
#include "app/window/theme.h"

namespace inkbench {
namespace {

constexpr double kFollowSeconds = 0.2;
constexpr float kListWidth = 214;

void close_button(Studies& studies, UiMap& ui_map) {
  const char* label = "Back to the pictures";
  const float width = button_width(label);
  const ImVec2 window = ImGui::GetWindowPos();
  const ImVec2 after = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({window.x + ImGui::GetWindowWidth() - width - scaled(4), window.y + scaled(1)});
  ImGui::PushStyleColor(ImGuiCol_Button, theme().bar);
  if (ImGui::Button(label)) studies.page_open = false;
  ImGui::PopStyleColor();
  ui_map.mark_item("close studies");
  help_for_item("Esc or F3. Studies go on meanwhile.");
  ImGui::SetCursorScreenPos(after);
}

}  // namespace

void follow_studies(Studies& studies, Problems& problems, WindowRequests& requests) {
  studies.poll();
  for (const Studies::Message& message : studies.take_messages())
    problems.tell(message.is_problem ? Severity::error : Severity::note, message.text);
  if (studies.is_busy()) requests.wake_in(kFollowSeconds);
}

void StudiesPage::draw() {
  panel_heading("Studies");
  close_button(studies_, ui_map_);
  ImGui::BeginChild("studies", {scaled(kListWidth), 0}, false, ImGuiWindowFlags_NoBackground);
  draw_study_list(document_, studies_, problems_, ui_map_);
  ImGui::EndChild();
  ImGui::SameLine(0, scaled(6));
  const ImVec2 top = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetContentRegionAvail().y;
  ImGui::GetWindowDrawList()->AddLine({top.x, top.y - scaled(6)}, {top.x, top.y + height + scaled(8)},
                                      theme().line);
  ImGui::SameLine(0, scaled(14));
  ImGui::BeginChild(
      "study", {0, 0}, false,
      ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoScrollbar);
  draw_banner(viewer_, problems_, ui_map_);
  if (studies_.shows_form()) {
    form_.draw();
  } else {
    results_.draw();
  }
  ImGui::EndChild();
}

}  // namespace inkbench
