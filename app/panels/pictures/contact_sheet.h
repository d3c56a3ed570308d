// The middle of the window: all buffers side by side, one that fills it, or two compared.
#pragma once

#include "app/window/workbench.h"

namespace inkbench {

/// Draws into the current ImGui window.
void draw_contact_sheet(Workbench& bench);

}  // namespace inkbench
