// SPDX-License-Identifier: MIT
#include "app/panels/widgets/held_drag.h"

#include <imgui_internal.h>

namespace inkbench {
namespace {

struct Held {
  ImVec2 place;
  int moved_frame = -1;     ///< That `place` has followed.
  int given_up_frame = -1;  ///< In which Esc was pressed.
};

Held& held() {
  static Held value;
  return value;
}

}  // namespace

ImVec2 drag_step() {
  const ImGuiIO& io = ImGui::GetIO();
  const float share = io.KeyShift ? kFineShare : 1.0F;
  return {io.MouseDelta.x * share, io.MouseDelta.y * share};
}

ImVec2 drag_place() {
  Held& now = held();
  const int frame = ImGui::GetFrameCount();
  if (ImGui::IsItemActivated()) {
    now.place = ImGui::GetIO().MousePos;
  } else if (now.moved_frame != frame) {
    const ImVec2 step = drag_step();
    now.place = {now.place.x + step.x, now.place.y + step.y};
  }
  now.moved_frame = frame;
  return now.place;
}

bool give_up_drag() {
  if (!ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) return false;
  const bool is_held = ImGui::IsAnyItemActive() && ImGui::IsAnyMouseDown() && !ImGui::GetIO().WantTextInput;
  if (!is_held) return false;
  held().given_up_frame = ImGui::GetFrameCount();
  ImGui::ClearActiveID();
  return true;
}

bool was_given_up() {
  return held().given_up_frame == ImGui::GetFrameCount() && ImGui::IsItemDeactivated();
}

}  // namespace inkbench
