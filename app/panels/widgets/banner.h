// What stands in the way, across the top of the pictures: what it is, and a way back.
#pragma once

#include "app/window/workbench.h"

namespace inkbench {

/// What it takes at that width.
float banner_height(const Workbench& bench, float width);

/// Draws into the current ImGui window; nothing where nothing is wrong.
void draw_banner(Workbench& bench);

}  // namespace inkbench
