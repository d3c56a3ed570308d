// The question about unsaved work of a window that died; nothing waits for its answer.
#pragma once

#include "app/window/workbench.h"

namespace inkbench {

float restore_bar_height(const Workbench& bench);

/// Draws into the current ImGui window; nothing where there is no such work.
void draw_restore_bar(Workbench& bench);

}  // namespace inkbench
