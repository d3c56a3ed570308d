// The row above the pictures: which buffers, comparing, pinning, what the mouse does, zoom.
#pragma once

#include "app/window/workbench.h"

namespace inkbench {

void draw_toolbar(Workbench& bench);

}  // namespace inkbench
