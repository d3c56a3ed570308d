// SPDX-License-Identifier: MIT
// Where the shaders are: the window takes them in whenever an editor saves one.
#pragma once

#include "app/window/ui_map.h"
#include "app/workbench/problems.h"

namespace inkbench {

/// A submenu for an open menu.
void shaders_menu(Problems& problems, UiMap& ui_map);

}  // namespace inkbench
