// The panel of timings: each pass, its GPU time, and whether it ran or was reused.
#pragma once

#include "app/window/workbench.h"

namespace inkbench {

void draw_timings(Workbench& bench);

}  // namespace inkbench
