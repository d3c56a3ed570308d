// SPDX-License-Identifier: MIT
// The panel of timings: each pass, its GPU time, and whether it ran or was reused.
#pragma once

#include "app/window/pass_timer.h"
#include "pipeline/pipeline.h"

namespace inkbench {

/// `passes`: of the pipeline; `window`: of the tiles and the window itself.
void draw_timings(const Pipeline& pipeline, const PassTimer& passes, const PassTimer& window);

}  // namespace inkbench
