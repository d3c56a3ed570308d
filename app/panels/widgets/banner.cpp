// SPDX-License-Identifier: MIT
#include "app/panels/widgets/banner.h"

#include <imgui.h>

#include <algorithm>

#include "app/panels/widgets/widgets.h"
#include "app/window/gui.h"
#include "app/window/theme.h"

namespace inkbench {
namespace {

const char* title_of(ProblemKind kind) {
  switch (kind) {
    case ProblemKind::drawing:
      return "This cannot be drawn; the pictures are the last good ones.";
    case ProblemKind::shader:
      return "A shader does not compile; the last good one is in use.";
    case ProblemKind::input:
      return "That was not accepted.";
  }
  return "";
}

struct ProblemPlan {
  float buttons, wrap, height;
};

ProblemPlan plan_of(ProblemKind kind, const std::string& text, float width) {
  const float buttons = scaled(kind == ProblemKind::drawing ? 156 : 84);
  const float wrap = std::max(width - buttons - scaled(20), scaled(60));
  const float text_height = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap).y;
  return {buttons, wrap, ImGui::GetTextLineHeight() + text_height + scaled(18)};
}

/// Returns whether it was dismissed.
bool draw_problem(Viewer& viewer, UiMap& ui_map, ProblemKind kind, const std::string& text) {
  ImGui::PushID(static_cast<int>(kind));
  const float pad = scaled(10);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const auto [buttons, wrap, height] = plan_of(kind, text, width);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, {low.x + width, low.y + height}, theme().bar, scaled(3));
  list.AddRectFilled(low, {low.x + scaled(4), low.y + height}, theme().error, scaled(2));
  ImVec2 place{low.x + pad + scaled(4), low.y + scaled(7)};
  list.AddText(fonts().bold, ImGui::GetFontSize(), place, theme().text, title_of(kind));
  place.y += ImGui::GetTextLineHeight() + scaled(3);
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), place, theme().error, text.c_str(), nullptr, wrap);
  ImGui::SetCursorScreenPos({low.x + width - buttons, low.y + scaled(8)});
  if (kind == ProblemKind::drawing && viewer.can_go_back()) {
    if (ImGui::Button("Go back")) viewer.go_back();
    ui_map.mark_item("go back");
    help_for_item("Back to the settings that gave the pictures.");
    ImGui::SameLine();
  }
  const bool dismissed = ImGui::Button("Dismiss");
  ui_map.mark_item("dismiss");
  ImGui::SetCursorScreenPos({low.x, low.y + height + scaled(4)});
  ImGui::PopID();
  return dismissed;
}

}  // namespace

float banner_height(const Problems& problems, float width) {
  float height = 0;
  for (const auto& [kind, text] : problems.all()) height += plan_of(kind, text, width).height + scaled(4);
  return height;
}

void draw_banner(Viewer& viewer, Problems& problems, UiMap& ui_map) {
  const std::map<ProblemKind, std::string> all = problems.all();  // drawing may dismiss some
  for (const auto& [kind, text] : all) {
    if (draw_problem(viewer, ui_map, kind, text)) problems.dismiss(kind);
  }
}

}  // namespace inkbench
