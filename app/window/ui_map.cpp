#include "app/window/ui_map.h"

#include <imgui.h>

namespace inkbench {

void UiMap::mark_item(const std::string& name) {
  if (!enabled_ || !ImGui::IsItemVisible()) return;
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  rects_[name] = {low.x, low.y, high.x, high.y};
}

void UiMap::mark(const std::string& name, const UiRect& rect) {
  if (enabled_) rects_[name] = rect;
}

}  // namespace inkbench
