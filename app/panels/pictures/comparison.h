// Two pictures in one place: both sides of a line that can be dragged, or one at a time.
#pragma once

#include <imgui.h>

#include "app/window/workbench.h"

namespace inkbench {

/// Draws into the rectangle of the current ImGui window.
void draw_comparison(Workbench& bench, ImVec2 low, ImVec2 room);

/// Begins a comparison of the selected buffer: against its pinned self where a state is pinned, else against
/// the one before it in the chain. Ends one that is on.
void toggle_comparison(Workbench& bench);

/// Pins the present state; a comparison that is on compares with it from then on.
void pin_state(Workbench& bench);

}  // namespace inkbench
