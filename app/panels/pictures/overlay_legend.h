// SPDX-License-Identifier: MIT
// Lines laid over the pictures: choosing them, and what their colours mean.
#pragma once

#include <imgui.h>

#include "app/window/ui_map.h"
#include "app/window/viewer.h"
#include "app/workbench/window_layout.h"

namespace inkbench {

/// Buttons for none, the reference lines, right and wrong.
void overlay_choice(WindowLayout& layout, UiMap& ui_map);

/// None, reference, right and wrong, and round again.
void next_overlay(WindowLayout& layout);

/// A line of swatches in the middle of a foot that begins at `foot`, over the pictures so that these stay
/// where they are; nothing where nothing is laid over.
void draw_overlay_legend(Viewer& viewer, const WindowLayout& layout, ImVec2 foot, float width);

}  // namespace inkbench
