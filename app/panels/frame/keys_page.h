// SPDX-License-Identifier: MIT
// The page of keys and mouse: shown at the first start, and by F1.
#pragma once

#include "app/window/ui_map.h"
#include "app/workbench/window_layout.h"

namespace inkbench {

/// Over everything else while `layout.show_welcome` says so.
void draw_keys_page(WindowLayout& layout, UiMap& ui_map);

}  // namespace inkbench
