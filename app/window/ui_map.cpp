// SPDX-License-Identifier: MIT
#include "app/window/ui_map.h"

#include <imgui_internal.h>

#include <algorithm>

namespace inkbench {

void UiMap::mark_item(const std::string& name) {
  if (!enabled_ || !ImGui::IsItemVisible()) return;
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  const ImRect& seen = ImGui::GetCurrentWindowRead()->ClipRect;
  rects_[name] = {std::max(low.x, seen.Min.x), std::max(low.y, seen.Min.y), std::min(high.x, seen.Max.x),
                  std::min(high.y, seen.Max.y)};
}

void UiMap::mark(const std::string& name, const UiRect& rect) {
  if (enabled_) rects_[name] = rect;
}

}  // namespace inkbench
