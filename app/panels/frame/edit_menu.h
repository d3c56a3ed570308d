// The menus that concern what is kept: Edit whole, and the File menu's part about files.
#pragma once

#include "app/window/workbench.h"

namespace inkbench {

/// Between BeginMenu("File") and EndMenu: opening, recent files, saving, copying.
void draw_file_items(Workbench& bench);

/// The whole menu.
void draw_edit_menu(Workbench& bench);

}  // namespace inkbench
