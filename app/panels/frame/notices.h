// The question about unsaved work and the problems, laid over the pictures so that these stay where they are.
#pragma once

#include <imgui.h>

#include "app/window/workbench.h"

namespace inkbench {

/// Into the current ImGui window from `low` on, at its whole width; after the pictures.
void draw_notices(Workbench& bench, ImVec2 low);

}  // namespace inkbench
