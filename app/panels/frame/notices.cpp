// SPDX-License-Identifier: MIT
#include "app/panels/frame/notices.h"

#include <algorithm>

#include "app/panels/frame/restore_bar.h"
#include "app/panels/widgets/banner.h"
#include "app/window/theme.h"

namespace inkbench {

void draw_notices(Document& document, Viewer& viewer, WindowLayout& layout, Keeping& keeping,
                  Problems& problems, UiMap& ui_map, ImVec2 low) {
  const ImVec2 after = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(low);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float height = restore_bar_height(keeping) + banner_height(problems, room.x);
  // A window of its own takes the mouse from the picture below; long compiler messages scroll in it.
  if (height > 0 && room.y > 1) {
    ImGui::PushStyleColor(ImGuiCol_ChildBg, theme().canvas);
    ImGui::BeginChild("notices", {0, std::min(height, room.y)});
    ImGui::PopStyleColor();
    draw_restore_bar(document, layout, keeping, ui_map);
    draw_banner(viewer, problems, ui_map);
    ImGui::EndChild();
  }
  ImGui::SetCursorScreenPos(after);
}

}  // namespace inkbench
