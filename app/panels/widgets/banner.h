// SPDX-License-Identifier: MIT
// What stands in the way, across the top of the pictures: what it is, and a way back.
#pragma once

#include "app/window/ui_map.h"
#include "app/window/viewer.h"
#include "app/workbench/problems.h"

namespace inkbench {

/// What it takes at that width.
float banner_height(const Problems& problems, float width);

/// Draws into the current ImGui window; nothing where nothing is wrong.
void draw_banner(Viewer& viewer, Problems& problems, UiMap& ui_map);

}  // namespace inkbench
