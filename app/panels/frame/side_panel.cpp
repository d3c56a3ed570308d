#include "app/panels/frame/side_panel.h"

#include <imgui.h>

#include <array>

#include "app/panels/widgets/widgets.h"

namespace inkbench {

void SidePanel::draw(Workbench& bench) {
  constexpr std::array kNames{"Inspector", "Judge"};
  auto page = static_cast<size_t>(bench.layout.side_page);
  heading_tabs(bench.ui_map, kNames, page);
  bench.layout.side_page = static_cast<SidePage>(page);
  ImGui::BeginChild("side page", {0, 0}, false, ImGuiWindowFlags_NoBackground);
  if (bench.layout.side_page == SidePage::judge) {
    judge_.draw(bench);
  } else {
    inspector_.draw(bench);
  }
  ImGui::EndChild();
}

}  // namespace inkbench
