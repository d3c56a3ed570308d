// Lines laid over the pictures: choosing them, and what their colours mean.
#pragma once

#include <imgui.h>

#include "app/window/workbench.h"

namespace inkbench {

/// Buttons for none, the reference lines, right and wrong.
void overlay_choice(Workbench& bench);

/// None, reference, right and wrong, and round again.
void next_overlay(Workbench& bench);

/// A line of swatches with its lower left corner at `foot`; returns its height, 0 where nothing is laid over.
float draw_overlay_legend(Workbench& bench, ImVec2 foot, float width);

}  // namespace inkbench
