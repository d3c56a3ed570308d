// SPDX-License-Identifier: MIT
// The question about unsaved work of a window that died; nothing waits for its answer.
#pragma once

#include "app/window/keeping.h"
#include "app/window/ui_map.h"
#include "app/workbench/document.h"
#include "app/workbench/window_layout.h"

namespace inkbench {

float restore_bar_height(const Keeping& keeping);

/// Draws into the current ImGui window; nothing where there is no such work.
void draw_restore_bar(Document& document, WindowLayout& layout, Keeping& keeping, UiMap& ui_map);

}  // namespace inkbench
