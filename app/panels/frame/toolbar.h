// SPDX-License-Identifier: MIT
// The row above the pictures: which buffers, comparing, pinning, what the mouse does, zoom.
#pragma once

#include "app/window/ui_map.h"
#include "app/window/view_state.h"
#include "app/window/viewer.h"
#include "app/workbench/window_layout.h"

namespace inkbench {

void draw_toolbar(Viewer& viewer, WindowLayout& layout, ViewState& view, UiMap& ui_map);

}  // namespace inkbench
