// SPDX-License-Identifier: MIT
// Which item the mouse rests on, and since when.
#include "app/panels/widgets/hover.h"

#include "app/panels/widgets/widgets.h"

namespace inkbench {
namespace {

struct Rest {
  ImVec2 low, high;
  double since = 0.0;
  int frame = -1;
  bool was_pressed = false;  ///< Who uses an item knows it: its help would lie over what changes.
};

Rest& rest() {
  static Rest value;
  return value;
}

bool is_same_place(const ImVec2& a, const ImVec2& b) {
  return a.x == b.x && a.y == b.y;
}

}  // namespace

double hover_seconds() {
  if (!ImGui::IsItemHovered()) return -1.0;
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  Rest& now = rest();
  const int frame = ImGui::GetFrameCount();
  const bool same = is_same_place(low, now.low) && is_same_place(high, now.high) && frame - now.frame <= 1;
  if (!same) now.since = ImGui::GetTime();
  now.was_pressed = (same && now.was_pressed) || ImGui::IsAnyMouseDown();
  now.low = low;
  now.high = high;
  now.frame = frame;
  return now.was_pressed ? -1.0 : ImGui::GetTime() - now.since;
}

bool is_hover_pending() {
  const Rest& now = rest();
  const bool waits = now.frame == ImGui::GetFrameCount() && !now.was_pressed;
  return waits && ImGui::GetTime() - now.since < kHelpDelay;
}

}  // namespace inkbench
