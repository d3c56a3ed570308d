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

void close_button(Workbench& bench) {
  const char* label = "Back to the pictures";
  const float width = button_width(label);
  const ImVec2 window = ImGui::GetWindowPos();
  const ImVec2 after = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({window.x + ImGui::GetWindowWidth() - width - scaled(4), window.y + scaled(1)});
  ImGui::PushStyleColor(ImGuiCol_Button, theme().bar);
  if (ImGui::Button(label)) bench.studies.page_open = false;
  ImGui::PopStyleColor();
  bench.ui_map.mark_item("close studies");
  help_for_item("Esc or F3. Studies go on meanwhile.");
  ImGui::SetCursorScreenPos(after);
}

}  // namespace

void follow_studies(Workbench& bench) {
  bench.studies.poll();
  for (const Studies::Message& message : bench.studies.take_messages())
    bench.tell(message.is_problem ? Severity::error : Severity::note, message.text);
  if (bench.studies.is_busy()) bench.wake_in(kFollowSeconds);
}

void StudiesPage::draw(Workbench& bench) {
  panel_heading("Studies");
  close_button(bench);
  ImGui::BeginChild("studies", {scaled(kListWidth), 0}, false, ImGuiWindowFlags_NoBackground);
  draw_study_list(bench);
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
  draw_banner(bench);
  if (bench.studies.shows_form()) {
    form_.draw(bench);
  } else {
    results_.draw(bench);
  }
  ImGui::EndChild();
}

}  // namespace inkbench
