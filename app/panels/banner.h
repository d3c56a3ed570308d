// What stands in the way, across the top of the pictures: what it is, and a way back.
#pragma once

#include "app/window/workbench.h"

namespace inkbench {

/// Draws nothing where nothing is wrong.
void draw_banner(Workbench& bench);

}  // namespace inkbench
