// SPDX-License-Identifier: MIT
// Lines laid over the pictures: choosing them, and what their colours mean.
#pragma once

#include <imgui.h>

#include "app/window/ui_map.h"
#include "app/window/viewer.h"
#include "app/workbench/window_layout.h"

namespace inkbench {

/// Buttons for none, the reference lines, right and wrong, causes.
void overlay_choice(WindowLayout& layout, UiMap& ui_map);

/// None, reference, right and wrong, causes, and round again.
void next_overlay(WindowLayout& layout);

/// Lines of swatches in the middle above `foot`, over the pictures so that these stay where they are; nothing
/// where nothing is laid over. A cause under the mouse is explained; it is `cause:KEY` of the map.
void draw_overlay_legend(Viewer& viewer, const WindowLayout& layout, UiMap& ui_map, ImVec2 foot, float width);

}  // namespace inkbench
