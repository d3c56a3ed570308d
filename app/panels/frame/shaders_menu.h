// Where the shaders are: the window takes them in whenever an editor saves one.
#pragma once

#include "app/window/workbench.h"

namespace inkbench {

/// A submenu for an open menu.
void shaders_menu(Workbench& bench);

}  // namespace inkbench
