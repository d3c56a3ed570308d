// SPDX-License-Identifier: MIT
// What all drags have in common: Shift makes them finer, and Esc gives them up, so that everything is as it
// was before the press. In: ImGui's last item, which the mouse holds. One drag is on at a time.
#pragma once

#include <imgui.h>

#include <optional>

namespace inkbench {

/// How much of the mouse's movement counts with Shift.
inline constexpr float kFineShare = 0.1F;

/// The mouse's movement since the last frame, finer with Shift.
ImVec2 drag_step();

/// Where the last item, which is held, is dragged to: the mouse's place at the press and the steps since
/// then.
ImVec2 drag_place();

/// Esc while the mouse holds an item: the item is let go. Once a frame, before all items. Returns whether Esc
/// was meant for a drag, and thus for nothing else.
bool give_up_drag();

/// Whether the last item was let go that way in this frame.
bool was_given_up();

/// What `value` was at the press of the last item, in the frame in which its drag is given up. Each frame,
/// before the item's drag changes it.
template <class T>
std::optional<T> given_back(const T& value) {
  static std::optional<T> before;
  if (ImGui::IsItemActivated()) before = value;
  return was_given_up() ? before : std::nullopt;
}

}  // namespace inkbench
