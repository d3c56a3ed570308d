// SPDX-License-Identifier: MIT
// The Edit menu: undo, the clipboard, resetting.
#pragma once

#include "app/window/pictures.h"
#include "app/window/ui_map.h"
#include "app/window/view_state.h"
#include "app/workbench/document.h"
#include "app/workbench/file_opener.h"
#include "app/workbench/problems.h"

namespace inkbench {

/// Between BeginMainMenuBar and EndMainMenuBar.
void draw_edit_menu(Document& document, const Pictures& pictures, const ViewState& view, FileOpener& files,
                    Problems& problems, UiMap& ui_map);

}  // namespace inkbench
