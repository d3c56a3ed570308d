// SPDX-License-Identifier: MIT
// Two pictures in one place: both sides of a line that can be dragged, or one at a time.
#pragma once

#include <imgui.h>

#include "app/window/pictures.h"
#include "app/window/ui_map.h"
#include "app/window/view_state.h"
#include "app/window/viewer.h"
#include "app/workbench/document.h"

namespace inkbench {

/// Draws into the rectangle of the current ImGui window.
void draw_comparison(Document& document, Viewer& viewer, ViewState& view, UiMap& ui_map, ImVec2 low,
                     ImVec2 room);

/// Begins a comparison of the selected buffer: against its pinned self where a state is pinned, else against
/// the one before it in the chain. Ends one that is on.
void toggle_comparison(Pictures& pictures, ViewState& view);

/// Pins the present state; a comparison that is on compares with it from then on.
void pin_state(Viewer& viewer, ViewState& view);

}  // namespace inkbench
