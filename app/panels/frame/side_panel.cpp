// SPDX-License-Identifier: MIT
#include "app/panels/frame/side_panel.h"

#include <imgui.h>

#include <array>

#include "app/panels/widgets/widgets.h"

namespace inkbench {

void SidePanel::draw() {
  constexpr std::array kNames{"Inspector", "Judge"};
  auto page = static_cast<size_t>(layout_.side_page);
  heading_tabs(ui_map_, kNames, page);
  layout_.side_page = static_cast<SidePage>(page);
  ImGui::BeginChild("side page", {0, 0}, false, ImGuiWindowFlags_NoBackground);
  if (layout_.side_page == SidePage::judge) {
    judge_.draw();
  } else {
    inspector_.draw();
  }
  ImGui::EndChild();
}

}  // namespace inkbench
