// SPDX-License-Identifier: MIT
// A ramp as a wide strip with its stops below it, to be dragged. In: a ramp. Out: what the person made of it.
#pragma once

#include <imgui.h>

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>

#include "app/window/ui_map.h"
#include "pipeline/params/value.h"

namespace inkbench {

/// Which stop is selected, and the drag that is on.
struct StripState {
  size_t selected = 0;
  std::optional<Ramp> before;  ///< The ramp as it was when the drag began, with the stop that is dragged.
  size_t dragged = 0;          ///< Its place in `before`.
  float grip = 0.0F;           ///< From the mouse to the stop, in pixels.
  bool moved = false;          ///< A mere click moves nothing.
};

struct StripResult {
  bool pressed = false, released = false;  ///< A drag begins, ends.
  bool double_clicked = false;             ///< On a stop.
  std::optional<Ramp> changed;
};

/// Drag a stop to move it (with Shift finer; Esc gives it up), far away from the strip to remove it; press
/// where none is to add one with the colour there. `colours`: the ramp from 0 to 1. A ramp without stops is
/// only shown. `name` is for the map.
StripResult ramp_strip_editor(const std::string& name, const Ramp& ramp, std::span<const glm::vec3> colours,
                              float width, StripState& state, UiMap& map);

/// The colours in a rectangle.
void draw_ramp_colours(ImDrawList& list, ImVec2 low, ImVec2 high, std::span<const glm::vec3> colours);

}  // namespace inkbench
