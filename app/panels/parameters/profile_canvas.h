// SPDX-License-Identifier: MIT
// The width along a stroke as a graph to draw in. In: a profile. Out: what the person made of it.
#pragma once

#include <imgui.h>

#include <optional>
#include <string>
#include <vector>

#include "app/window/ui_map.h"
#include "app/workbench/profile_edit.h"

namespace inkbench {

/// The drag that is on.
struct CanvasState {
  std::optional<WidthProfile> before;  ///< The profile as it was at the press.
  std::optional<size_t> dragged;       ///< A point of it; else a free line is drawn.
  std::vector<ProfilePoint> drawn;     ///< That line.
  ImVec2 grip{};                       ///< From the mouse to the point, in pixels.
  bool moved = false;                  ///< A mere click draws no line.
};

struct CanvasResult {
  bool pressed = false, released = false;  ///< A drag begins, ends.
  std::optional<WidthProfile> changed;
};

/// Drag a point to move it (with Shift finer; Esc gives it up), double click it to remove it; drag elsewhere
/// to draw the width freely, or click there for a point. `name` is for the map, which gets the graph without
/// its margins.
CanvasResult profile_canvas(const std::string& name, const WidthProfile& profile, ImVec2 size,
                            CanvasState& state, UiMap& map);

}  // namespace inkbench
