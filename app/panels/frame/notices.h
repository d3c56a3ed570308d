// SPDX-License-Identifier: MIT
// The question about unsaved work and the problems, laid over the pictures so that these stay where they are.
#pragma once

#include <imgui.h>

#include "app/window/keeping.h"
#include "app/window/ui_map.h"
#include "app/window/viewer.h"
#include "app/workbench/document.h"
#include "app/workbench/problems.h"
#include "app/workbench/window_layout.h"

namespace inkbench {

/// Into the current ImGui window from `low` on, at its whole width; after the pictures.
void draw_notices(Document& document, Viewer& viewer, WindowLayout& layout, Keeping& keeping,
                  Problems& problems, UiMap& ui_map, ImVec2 low);

}  // namespace inkbench
