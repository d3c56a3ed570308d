// The line at the bottom: scene, size, zoom, renderer, how long a frame takes.
#pragma once

#include "app/window/workbench.h"

namespace inkbench {

void draw_status_bar(Workbench& bench);

}  // namespace inkbench
